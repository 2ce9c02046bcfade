#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "io/fields.hpp"
#include "io/table.hpp"

namespace ccdfuzz {

/// If the path is the standard output, what is printed from now on goes to stderr: it is no part of
/// what is written there.
void leave_stdout_to(const std::string& path);

/// Writes text to stdout. A failure (a full disk, /dev/full) is remembered for flush_stdout. Names
/// of files, methods and cases may hold what a terminal obeys: control characters but newlines are
/// shown (shown_lines).
void print_out(const std::string& text);

/// The same of a table, in colour where that is wanted.
void print_table(const Table& table);

/// For a table of any length: prints its rows so far and forgets them, once there are `least`.
/// Columns are then as wide as so many rows need.
void print_rows(Table& table, size_t least = 0);

/// Writes text to stderr, control characters shown. Where that fails there is nobody to tell.
void print_err(const std::string& text);

/// One JSON object on a line of its own: a record, or what a function of an archive names.
template <class Row>
void print_row(const Row& row) {
  print_out(to_json(row) + "\n");
}

/// Errors: something that was printed did not reach its destination.
Result<void> flush_stdout();

/// One line on stderr that is rewritten in place, at most ten times a second. If stderr is no
/// terminal, a line after 20 s and then each time that twice as long has passed, or ten minutes.
/// Safe to call from several threads.
class Progress {
 public:
  Progress();
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share: how much is done, in [0, 1]. The time left follows from its growth since the first
  /// call, as an earlier run may have done a part. note: what to show beside the bar, of one line.
  /// done: how many `unit`s so far, of which the rate is shown.
  void show(double share, const std::string& note, std::uint64_t done, std::string_view unit);
  /// Wipes the line, so that other output may follow.
  void clear();

 private:
  std::mutex mutex_;
  const bool on_terminal_;
  bool drawn_ = false;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point next_;
  struct Seen {
    double share;
    std::chrono::steady_clock::time_point at;
  };
  std::optional<Seen> first_;
};

}  // namespace ccdfuzz
