#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/no_process.hpp"
#include "certify/checker/work_done.hpp"
#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "files/check_file.hpp"
#include "io/fields.hpp"
#include "io/in_order.hpp"
#include "io/output_file.hpp"
#include "io/run_file.hpp"
#include "io/table.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

/// Resumes the run whose result goes to `output`, or begins it, and says so. unit: of its items.
/// Throws BadInput: as RunFile::open; the output cannot be written.
RunFile resumed_run(const RunHeader& header, const std::string& output, const char* unit);

/// Counts of the cases that a command was given.
struct CaseCount {
  std::uint64_t cases = 0;
  /// Cases whose absence of contact, up to t_max or else up to clear_until, has no proof but the
  /// word of a method. Nothing is judged by it.
  std::uint64_t by_word = 0;
  /// With a truth and a label of a query CSV; of them, those whose label says otherwise.
  std::uint64_t labels = 0, wrong_labels = 0;
  /// Numbers of query CSVs that became the nearest double, and the queries with such.
  std::uint64_t rounded = 0, rounded_queries = 0;

  void add(const Case& value);
};

/// Whether a case is asked about in this run: not one whose answers are known.
inline bool is_anew(const NamedCase&) {
  return true;
}

/// The common part of commands: threads, --json, a table or rows on stdout, progress, interrupts.
class Session {
 public:
  int threads = 1;
  bool json = false;
  std::string command;               ///< the name of the one that runs
  std::vector<Property> properties;  ///< all that there are
  FindSuite find_suite;
  std::map<std::string, std::string> asked;  ///< the command's options that decide its result
  CaseCount counts;                          ///< of those that the command has read

  /// Begins a table whose rows are printed as they come, 1,000 at a time.
  Table& begin_table(std::vector<Table::Column> columns) {
    return table_.emplace(std::move(columns));
  }
  /// Prints the rest of the table, and a blank line if it had rows and more text follows.
  void end_table(bool text_follows = false);

  /// The next row of the table, if there is one, begins a group of this title.
  void start_group(const std::string& title) { table_->start_group(title); }
  /// Prints the row as a line of JSON if --json was given (print_row), and cells() as a row of the
  /// table otherwise.
  template <class Row, class Cells>
  void show(const Row& row, const Cells& cells) {
    if (json) return print_row(row);
    print_rows(*table_, 1000);
    table_->add_row(cells());
  }
  /// Prints the row as a line of JSON if --json was given, and the text otherwise.
  template <class Row>
  void say(const Row& row, const std::string& text) {
    progress_.clear();
    json ? print_row(row) : print_out(text);
  }
  /// Says on stderr what is no result: "ccdfuzz: COMMAND: …".
  template <class... Args>
  void remark(fmt::format_string<Args...> format, Args&&... args) {
    progress_.clear();
    print_err(fmt::format("ccdfuzz: {}: {}\n", command,
                          fmt::format(format, std::forward<Args>(args)...)));
  }
  /// The summary for people: nothing with --json.
  void summary(const std::string& text) {
    if (!json) print_out(text + "\n");
  }

  /// Runs work(item) on `threads` threads for each that cases.next() gives, a NamedCase or what
  /// derives from it. sink(item, row) sees the rows in the same order, with progress. A signal, or
  /// that no process answers (unless_refused), ends the reading; what was begun still reaches sink
  /// after a signal. The checks within work count (RunWork). Says how many numbers were rounded.
  /// Throws, after all rows before it: BadInput of next or of RunWork::add; what work or sink does.
  template <class Row, class Cases, class Work, class Sink>
  void each_case(Cases cases, const Work& work, const Sink& sink) {
    using Item = typename decltype(cases.next())::value_type::value_type;
    struct Done {
      Result<Item> item;
      std::optional<Row> row = {};
      std::exception_ptr thrown = {};
      std::uint64_t checking = 0;  ///< what work() checked
    };
    bool is_readable = true;
    std::uint64_t anew = 0;
    const auto next = [&]() -> std::optional<Result<Item>> {
      if (!is_readable || interrupted()) return std::nullopt;
      auto given = cases.next();
      is_readable = given.has_value();
      if (given && !*given) return std::nullopt;
      return std::move(given).map([](auto item) { return *std::move(item); });
    };
    const auto done_with = [&](Result<Item> item) {
      Done done{std::move(item)};
      if (!done.item) return done;
      const std::uint64_t before = work_done_here();
      try {
        done.row.emplace(work(*done.item));
      } catch (...) {
        done.thrown = std::current_exception();
      }
      done.checking = work_done_here() - before;
      return done;
    };
    unless_refused([&] {
      stream_in_order<Done>(threads, next, done_with, [&](Done done) {
        const Item item = need(std::move(done.item));
        if (done.thrown) std::rethrow_exception(done.thrown);
        need(RunWork::add(item, done.checking));
        counts.add(item.value);
        sink(item, *std::move(done.row));
        if (is_anew(item)) ++anew;
        progress_.show(item.share, item.id, anew, "cases");
      });
    });
    progress_.clear();
    if (!interrupted()) note_rounded();
  }
  /// The next case of a stream, checked and counted. Errors: as next_checked.
  Result<std::optional<NamedCase>> next_case(CaseStream& cases);
  /// Says on stderr how many numbers of the cases were rounded.
  void note_rounded();
  /// The same of truths that are not as they should be.
  void note_truths();

  /// Where no process answers, and not because of a signal, the command is to end as after one. The
  /// program then ends with this error.
  template <class Work>
  void unless_refused(const Work& work) {
    try {
      work();
    } catch (const NoProcess&) {
      if (!catch_interrupts()) refused_ = std::current_exception();
    }
  }
  const std::exception_ptr& refused() const { return refused_; }

  /// True iff the command is to end with what it has: a signal asked for it, or refused().
  bool interrupted() const { return catch_interrupts() || refused_; }
  /// The exit code of the command: `code`, or where it was interrupted that of the signal.
  int exit_code(int code) {
    if (!interrupted()) return code;
    return end_early("what is shown is of what was done until then");
  }

  /// Says on stderr that the command was interrupted, and what follows from that; the exit code.
  int end_early(const std::string& what_follows);
  /// The same, and after how much.
  int end_early(std::uint64_t done, const char* unit, const std::string& what_follows);
  /// The same, and that a file was not written.
  int end_unwritten(std::uint64_t done, const char* unit, const std::string& path) {
    return end_early(done, unit, is_stream(path) ? "" : path + " was not written");
  }

  Progress& progress() { return progress_; }

 private:
  Progress progress_;
  std::optional<Table> table_;
  std::exception_ptr refused_;
};

}  // namespace ccdfuzz
