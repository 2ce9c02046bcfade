#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <atomic>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/fp_guard.hpp"

namespace ccdfuzz {

/// Whether results reach a sink in the order of their items, or as they come.
enum class Order { kOfItems, kNone };

/// Whether work is in vain that runs in stream_in_order: next, sink, or the work on another item
/// threw. It may poll this, and return anything.
inline bool is_in_vain() {
  return tbb::is_current_task_group_canceling();
}

/// Runs work(item) on `threads` threads for each item that next() returns, until it returns
/// nothing. Sink gets the results one at a time, in the order of the items, on any number of
/// threads. next returns a std::optional and is called by one thread at a time. All three run in a
/// sound floating-point environment, whatever the threads were started in (FpGuard). They may
/// throw: the first exception ends the run and is thrown here. At most 64 items per thread are
/// held, and one without an order. Requires threads ≥ 1. Returns how many results reached sink.
template <class Result, class Next, class Work, class Sink>
size_t stream_in_order(int threads, const Next& next, const Work& work, const Sink& sink,
                       Order order = Order::kOfItems) {
  using Item = decltype(next());
  const bool has_order = order == Order::kOfItems;
  // Enough in flight that one slow item does not idle the other threads, few enough to stay small.
  const auto in_flight = static_cast<size_t>(threads) * (has_order ? 64 : 1);
  // Calls from several threads at once are not wanted, so the arena may be as wide as asked for,
  // also beyond the number of cores.
  const tbb::global_control width(tbb::global_control::max_allowed_parallelism,
                                  static_cast<size_t>(threads));
  tbb::task_arena arena(threads);
  size_t done = 0;
  arena.execute([&] {
    tbb::parallel_pipeline(
        in_flight,
        tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order,
                                     [&](tbb::flow_control& control) -> Item {
                                       const FpGuard guard;
                                       Item item = next();
                                       if (!item) control.stop();
                                       return item;
                                     }) &
            tbb::make_filter<Item, Result>(tbb::filter_mode::parallel,
                                           [&](Item item) {
                                             const FpGuard guard;
                                             return work(*std::move(item));
                                           }) &
            tbb::make_filter<Result, void>(has_order ? tbb::filter_mode::serial_in_order
                                                     : tbb::filter_mode::serial_out_of_order,
                                           [&](Result result) {
                                             const FpGuard guard;
                                             sink(std::move(result));
                                             ++done;
                                           }));
  });
  return done;
}

/// The same with the items 0, 1, …, count − 1. stop, if given, is read before each item is handed
/// out. Once it is true no more are, but the results of those before still reach sink.
template <class Result, class Work, class Sink>
size_t run_in_order(size_t count, int threads, const Work& work, const Sink& sink,
                    const std::atomic<bool>* stop = nullptr) {
  size_t next = 0;
  return stream_in_order<Result>(
      threads,
      [&]() -> std::optional<size_t> {
        const bool stopped = stop != nullptr && stop->load(std::memory_order_relaxed);
        return stopped || next == count ? std::nullopt : std::optional(next++);
      },
      work, sink);
}

}  // namespace ccdfuzz
