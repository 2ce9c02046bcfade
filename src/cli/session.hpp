#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/terminal.hpp"
#include "eval/stream_cases.hpp"
#include "io/fields.hpp"
#include "io/output_file.hpp"
#include "io/run_file.hpp"
#include "io/table.hpp"
#include "properties/suites.hpp"

namespace ccdfuzz {

/// Resumes the run whose result goes to `output`, or begins it, and says so. unit: of its items.
/// Throws BadInput: as RunFile::open; the output cannot be written.
RunFile resumed_run(const RunHeader& header, const std::string& output, const char* unit);

/// Numbers of query CSVs that became the nearest double, and the queries with such.
struct RoundedNumbers {
  std::uint64_t numbers = 0, queries = 0;
  void add(const Case& value);
};

/// The common part of commands: threads, --json, a table or rows on stdout, progress, interrupts.
class Session {
 public:
  int threads = 1;
  bool json = false;
  std::string command;               ///< the name of the one that runs
  std::vector<Property> properties;  ///< all that there are
  FindSuite find_suite;
  std::map<std::string, std::string> asked;  ///< the command's options that decide its result

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

  /// stream_cases with progress, until a signal or until stop is true. Says how many numbers were
  /// rounded. work(named) and sink(named, row) may throw BadInput, whose error it is.
  template <class Row, class Work, class Sink>
  void each_case(CaseStream cases, const Work& work, const Sink& sink,
                 const std::atomic<bool>* stop = nullptr) {
    const std::atomic<bool>& signalled = catch_interrupts();
    std::uint64_t done = 0;
    RoundedNumbers rounded;
    const Result<void> read = stream_cases<Row>(
        threads, [&] { return cases.next(); },
        [&](NamedCase& named) -> Result<Row> {
          try {
            return work(named);
          } catch (const BadInput& bad) {
            return tl::unexpected(bad.error);
          }
        },
        [&](const NamedCase& named, Row row) {
          rounded.add(named.value);
          sink(named, std::move(row));
          progress_.show(named.share, named.id, ++done, "cases");
        },
        [&] { return signalled || (stop != nullptr && *stop); });
    progress_.clear();
    need(read);
    if (!signalled) note(rounded);
  }
  void note(const RoundedNumbers& rounded) {
    if (rounded.queries == 0) return;
    remark("{} numbers of {} queries are no doubles and were rounded", rounded.numbers,
           rounded.queries);
  }

  /// True iff a signal asked the command to end.
  bool interrupted() const { return catch_interrupts(); }
  /// The exit code of the command: `code`, or that of the signal, which it says.
  int exit_code(int code) {
    if (!interrupted()) return code;
    remark("interrupted: what is shown is of what was done until then");
    return interrupted_exit_code();
  }

  /// Says on stderr after how much a signal ended the command, and what follows from that; the exit
  /// code.
  int end_early(std::uint64_t done, const char* unit, const std::string& what_follows);
  /// The same, and that a file was not written.
  int end_unwritten(std::uint64_t done, const char* unit, const std::string& path) {
    return end_early(done, unit, is_stream(path) ? "" : path + " was not written");
  }

  Progress& progress() { return progress_; }

 private:
  Progress progress_;
  std::optional<Table> table_;
};

}  // namespace ccdfuzz
