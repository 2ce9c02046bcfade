#pragma once

#include <atomic>
#include <optional>
#include <utility>

#include "certify/checker/work_done.hpp"
#include "files/case_files.hpp"
#include "files/run_work.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

/// Reads one case at a time and runs work(asked) for each on `threads` threads. make(NamedCase) is
/// called for each case in order, by one thread at a time. It returns a Result<std::optional> of
/// what is asked, which is a NamedCase or derives from it; nothing skips the case. work returns a
/// Result<Row>. sink(asked, row, share) sees the rows in that order; share is how much of the files
/// has been read. Once stop() is true no more is read, but what was begun still reaches sink. The
/// checks within work count (RunWork). Errors: the first of reading, of make, of work or of
/// RunWork::add, after all rows before it.
template <class Row, class Make, class Work, class Sink, class Stop>
Result<void> stream_cases(CaseStream cases, int threads, const Make& make, const Work& work,
                          const Sink& sink, const Stop& stop) {
  using Subject = typename decltype(make(std::declval<NamedCase>()))::value_type::value_type;
  struct Item {
    Result<Subject> asked;
    double share = 0;
  };
  struct Done {
    Item item;
    Result<Row> row;
    std::uint64_t checking = 0;  ///< what work() checked
  };
  Result<void> result;
  std::atomic<bool> ended = false;
  stream_in_order<Done>(
      threads,
      [&]() -> std::optional<Item> {
        while (!ended && !stop()) {
          Result<std::optional<NamedCase>> next = cases.next();
          if (next && !*next) break;
          auto made = next ? make(**std::move(next)) : tl::unexpected(next.error());
          if (made && !*made) continue;
          if (!made) ended = true;
          return Item{std::move(made).map([](auto asked) { return *std::move(asked); }),
                      cases.share()};
        }
        return std::nullopt;
      },
      [&](Item item) {
        const std::uint64_t before = work_done_here();
        Result<Row> row =
            item.asked ? work(*item.asked) : Result<Row>(tl::unexpected(item.asked.error()));
        return Done{std::move(item), std::move(row), work_done_here() - before};
      },
      [&](Done done) {
        if (!result) return;
        result = done.row ? RunWork::add(*done.item.asked, done.checking)
                          : Result<void>(tl::unexpected(done.row.error()));
        if (!result) {
          ended = true;
        } else {
          sink(*done.item.asked, *std::move(done.row), done.item.share);
        }
      });
  return result;
}

}  // namespace ccdfuzz
