#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cli/terminal.hpp"

namespace ccdfuzz {

/// What became of the files that fuzzers left, and of the inputs in them.
struct TriageCounts {
  std::uint64_t files = 0, files_done = 0, files_unread = 0;
  std::uint64_t inputs = 0;
  std::uint64_t failures = 0;  ///< of all inputs and methods
  std::uint64_t known = 0;     ///< of those, how many are like one that is stored
  std::uint64_t harmless = 0;  ///< inputs on which nothing fails
  std::uint64_t refuting = 0;  ///< inputs of cases that refute a claim, but by no full run
  std::uint64_t finds = 0;
};

/// The files that the arguments name, in order; folders stand for what is in them, but for what is
/// still being written (OutputFile). Errors: one that
/// is not there or cannot be read.
Result<std::vector<std::string>> triage_files(const std::vector<std::string>& inputs);

/// An input of a fuzz target. Errors: no file; it cannot be read; it is larger than any.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path);

/// Goes through files, with progress.
class TriageWalk {
 public:
  /// What is left to do with a file that was read; false: it is not done, or to stay.
  /// Errors: of the store.
  using Work = std::function<Result<bool>()>;
  /// Errors: it is no input; it is told, and left as it is.
  using Read = std::function<Result<Work>(const std::string& file)>;

  /// is_over: no further work. remove: each file that is done.
  TriageWalk(std::function<bool()> is_over, bool remove)
      : is_over_(std::move(is_over)), remove_(remove) {}

  /// A file that is no more is passed over. Errors: of the work; a file that cannot be removed.
  Result<void> go(const std::vector<std::string>& files, const Read& read);

  /// On stderr.
  void note(const std::string& line);
  /// One more find; what is printed after that stands on a line of its own.
  void note_find();
  TriageCounts& counts() { return counts_; }

 private:
  std::function<bool()> is_over_;
  bool remove_;
  Progress progress_;
  TriageCounts counts_;
};

/// The last line, or the last JSON object. folder: where finds are.
void print_triage(const TriageCounts& counts, const std::string& folder, bool json);

}  // namespace ccdfuzz
