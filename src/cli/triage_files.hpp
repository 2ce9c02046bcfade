#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "cli/terminal.hpp"
#include "hunt/triage.hpp"

namespace ccdfuzz {

/// The results for the files that fuzzers left, and for the inputs in them.
struct TriageCounts {
  std::uint64_t files = 0, files_done = 0, files_unread = 0;
  TriageTally tally;
  std::uint64_t finds = 0;

  static void fields(auto& archive, auto& counts) {
    archive.constant("row", "summary");
    archive("files", counts.files);
    archive("files_done", counts.files_done);
    archive("files_unread", counts.files_unread);
    TriageTally::fields(archive, counts.tally);
    archive("finds", counts.finds);
  }
};

/// The files that the arguments name, in order; folders stand for what is in them, but for what is
/// still being written (OutputFile). Errors: one that
/// is not there or cannot be read.
Result<std::vector<std::string>> triage_files(const std::vector<std::string>& inputs);

/// An input of a fuzz target. Errors: as read_file; it is larger than any.
Result<std::vector<std::uint8_t>> read_bytes(const std::string& path);

/// Goes through files, with progress.
class TriageWalk {
 public:
  /// The rest of the work on a file that was read. Returns false if it is not done, or the file is
  /// to stay. Throws BadInput: of the store.
  using Work = std::function<bool()>;
  /// Errors: it is no input; says so, and leaves it as it is.
  using Read = std::function<Result<Work>(const std::string& file)>;

  /// is_over: no further work. remove: each file that is done.
  TriageWalk(std::function<bool()> is_over, bool remove)
      : is_over_(std::move(is_over)), remove_(remove) {}

  /// A file that is no more is passed over. Throws BadInput: of the work; a file that cannot be
  /// removed.
  void go(const std::vector<std::string>& files, const Read& read);

  /// On stderr.
  void note(const std::string& line);
  /// One more find. Later output is on a line of its own.
  void note_find();
  TriageCounts& counts() { return counts_; }

 private:
  std::function<bool()> is_over_;
  bool remove_;
  Progress progress_;
  TriageCounts counts_;
};

/// "3 of 3 files: …". folder: where finds are.
std::string to_text(const TriageCounts& counts, const std::string& folder);

}  // namespace ccdfuzz
