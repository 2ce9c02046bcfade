#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <utility>

namespace ccdfuzz {

/// Runs work(0), work(1), …, work(count − 1) on `threads` threads and hands the results to sink
/// one at a time in the order of the indices, so that what sink sees does not depend on the
/// number of threads. Both may throw: the first exception ends the run and is thrown here.
/// stop, if given, is read before each index is handed out; once it is true no more are, and what
/// was handed out still reaches sink. Requires threads ≥ 1. Returns how many results reached sink.
template <class Result, class Work, class Sink>
size_t run_in_order(size_t count, int threads, const Work& work, const Sink& sink,
                    const std::atomic<bool>* stop = nullptr) {
  // Enough in flight that one slow item does not idle the other threads, few enough to stay small.
  const auto in_flight = static_cast<size_t>(threads) * 64;
  // Calls from several threads at once are not wanted, so the arena may be as wide as asked for,
  // also beyond the number of cores.
  const tbb::global_control width(tbb::global_control::max_allowed_parallelism,
                                  static_cast<size_t>(threads));
  tbb::task_arena arena(threads);
  size_t next = 0;
  size_t done = 0;
  arena.execute([&] {
    tbb::parallel_pipeline(
        in_flight,
        tbb::make_filter<void, size_t>(tbb::filter_mode::serial_in_order,
                                       [&](tbb::flow_control& control) -> size_t {
                                         if (next == count ||
                                             (stop && stop->load(std::memory_order_relaxed))) {
                                           control.stop();
                                           return 0;
                                         }
                                         return next++;
                                       }) &
            tbb::make_filter<size_t, Result>(tbb::filter_mode::parallel,
                                             [&](size_t index) { return work(index); }) &
            tbb::make_filter<Result, void>(tbb::filter_mode::serial_in_order, [&](Result result) {
              sink(std::move(result));
              ++done;
            }));
  });
  return done;
}

}  // namespace ccdfuzz
