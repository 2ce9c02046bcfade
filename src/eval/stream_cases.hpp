#pragma once

#include <atomic>
#include <optional>
#include <utility>

#include "certify/checker/work_done.hpp"
#include "files/check_file.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

/// Runs work(asked) on `threads` threads for each that next() returns, a Result<std::optional>. It
/// is called by one thread at a time, until there is nothing more. What is asked is a NamedCase or
/// derives from it. work returns a Result<Row>. sink(asked, row) sees the rows in the same order.
/// Once stop() is true no more is read, but what was begun still reaches sink. The checks within
/// work count (RunWork). Errors: the first of next, of work or of RunWork::add, after all rows
/// before it.
template <class Row, class Next, class Work, class Sink, class Stop>
Result<void> stream_cases(int threads, const Next& next, const Work& work, const Sink& sink,
                          const Stop& stop) {
  using Item = Result<typename decltype(next())::value_type::value_type>;
  struct Done {
    Item asked;
    Result<Row> row;
    std::uint64_t checking = 0;  ///< what work() checked
  };
  Result<void> result;
  std::atomic<bool> ended = false;
  stream_in_order<Done>(
      threads,
      [&]() -> std::optional<Item> {
        if (ended || stop()) return std::nullopt;
        auto given = next();
        if (given && !*given) return std::nullopt;
        if (!given) ended = true;
        return std::move(given).map([](auto asked) { return *std::move(asked); });
      },
      [&](Item asked) {
        const std::uint64_t before = work_done_here();
        Result<Row> row = asked ? work(*asked) : Result<Row>(tl::unexpected(asked.error()));
        return Done{std::move(asked), std::move(row), work_done_here() - before};
      },
      [&](Done done) {
        if (!result) return;
        result = done.row ? RunWork::add(*done.asked, done.checking)
                          : Result<void>(tl::unexpected(done.row.error()));
        if (!result) {
          ended = true;
        } else {
          sink(*done.asked, *std::move(done.row));
        }
      });
  return result;
}

}  // namespace ccdfuzz
