#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

#include "certify/checker/work_done.hpp"
#include "files/case_files.hpp"
#include "files/run_work.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

inline const NamedCase& named_of(const NamedCase& named) {
  return named;
}
template <class Asked>
const NamedCase& named_of(const Asked& asked) {
  return asked.named();
}

/// Reads one case at a time and runs work(asked, part) for part = 0, …, parts − 1 of each case on
/// `threads` threads. make(NamedCase) is called for each case in order, by one thread at a time. It
/// returns a Result of a shared pointer to what is asked; null skips the case. work returns a
/// Result<Row>. sink(asked, part, row, share) sees the rows in that order; share is how much of the
/// files has been read. Once stop() is true no more is read, but what was begun still reaches sink.
/// The checks within work count (RunWork). Errors: the first of reading, of make, of work or of
/// RunWork::add, after all rows before it.
template <class Row, class Make, class Work, class Sink, class Stop>
Result<void> stream_cases(CaseStream cases, size_t parts, int threads, const Make& make,
                          const Work& work, const Sink& sink, const Stop& stop) {
  using Subject = typename decltype(make(std::declval<NamedCase>()))::value_type::element_type;
  struct Item {
    std::shared_ptr<Subject> asked;
    size_t part = 0;
    double share = 0;
    std::optional<InputError> unreadable;
  };
  struct Done {
    Item item;
    Result<Row> row;
    std::uint64_t checking = 0;  ///< what work() checked
  };
  Item current;
  Result<void> result;
  std::atomic<bool> ended = false;
  stream_in_order<Done>(
      threads,
      [&]() -> std::shared_ptr<Item> {
        if (ended || current.unreadable || stop()) return nullptr;
        if (current.asked != nullptr && ++current.part < parts) {
          return std::make_shared<Item>(current);
        }
        for (current = {}; current.asked == nullptr && !current.unreadable;) {
          Result<std::optional<NamedCase>> next = cases.next();
          if (next && !*next) return nullptr;
          auto made = next ? make(**std::move(next)) : tl::unexpected(next.error());
          if (!made) current.unreadable = made.error();
          if (made) current.asked = *std::move(made);
          current.share = cases.share();
        }
        return std::make_shared<Item>(current);
      },
      [&](Item& item) {
        const std::uint64_t before = work_done_here();
        Result<Row> row = item.unreadable ? Result<Row>(tl::unexpected(*item.unreadable))
                                          : work(*item.asked, item.part);
        return Done{std::move(item), std::move(row), work_done_here() - before};
      },
      [&](Done done) {
        if (!result) return;
        result = !done.row ? Result<void>(tl::unexpected(done.row.error()))
                           : RunWork::add(named_of(*done.item.asked), done.checking);
        if (!result) {
          ended = true;
        } else {
          sink(*done.item.asked, done.item.part, *std::move(done.row), done.item.share);
        }
      });
  return result;
}

}  // namespace ccdfuzz
