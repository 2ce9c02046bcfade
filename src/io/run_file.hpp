#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "base/shard.hpp"
#include "io/descriptor.hpp"
#include "io/line_reader.hpp"

namespace ccdfuzz {

/// The options of a long run. All but the share must agree for a run to resume, and for shares
/// to be merged.
struct RunHeader {
  std::string run;                           ///< the command
  std::string version;                       ///< the program's
  std::vector<std::string> inputs;           ///< the files that it reads
  std::map<std::string, std::string> asked;  ///< all else that decides the result, by name
  std::uint64_t items = 0;                   ///< in all shares together; 0: not known
  Shard shard;

  static void fields(auto& archive, auto& header) {
    archive.format("ccdfuzz-run", 1, 1);
    archive("run", header.run);
    archive("ccdfuzz", header.version);
    archive("inputs", header.inputs);
    archive("asked", header.asked);
    archive("items", header.items);
    archive("shard", header.shard);
  }

  /// Where the other header differs from this one, except for the share: "--seed 7 in place of 8".
  /// Nothing if it does not.
  std::optional<std::string> difference(const RunHeader& other) const;
};

/// The lines of a run file: the header, then one for each finished item of the share. An item is a
/// JSON object. It begins with its "index" in the run, unless the number of items is unknown. A
/// last line without its end was being written when the run ended, and does not count.
class RunLines {
 public:
  /// most: items to give. Errors: the file cannot be read, or its first line is no header; naming
  /// the path.
  static Result<RunLines> open(const std::string& path,
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

  const RunHeader& header() const { return header_; }
  /// The line of the next item; nothing at the end. Valid until the next call. Errors: reading; it
  /// is the line of another item, or one too many.
  Result<std::optional<std::string_view>> next();
  /// Bytes of the lines given so far, the header included.
  std::uint64_t bytes() const { return bytes_; }
  /// "path:number" of the line given last.
  std::string where() const { return lines_.here(); }

 private:
  explicit RunLines(LineReader lines) : lines_(std::move(lines)) {}

  Result<std::optional<std::string_view>> next_whole();

  LineReader lines_;
  RunHeader header_;
  std::uint64_t most_ = 0;
  std::uint64_t given_ = 0;
  std::uint64_t bytes_ = 0;
};

/// The finished part of a long run: a line per item, in a file that is only appended to. A run
/// that was killed, at any moment, resumes after the last complete line. A finished share is such a
/// file, too: all its items, under the name of the output.
class RunFile {
 public:
  /// Where the file is while the run whose result goes to `output` is under way.
  static std::string path_for(const std::string& output) { return output + ".partial"; }

  /// Resumes the file at `path`, or begins it where there is none. Errors: it belongs to a run with
  /// other options, naming them. Another process has it (where the file system has locks). It is no
  /// run file. What the system says. After an error the file is unchanged.
  static Result<RunFile> open(const std::string& path, const RunHeader& header);

  /// How many items are done.
  std::uint64_t size() const { return size_; }
  /// Their lines. Errors: as RunLines::open.
  Result<RunLines> done() const { return RunLines::open(path_, size_); }

  /// Appends the line of the next item, as RunLines has it. Requires no line breaks. Errors: what
  /// the system says, naming the path. No appending after an error.
  Result<void> append(std::string_view line);

  /// The run is over: its file is flushed to the disk and becomes `output`.
  Result<void> rename(const std::string& output);
  /// The run is over and its result is elsewhere: removes the file.
  Result<void> remove();

 private:
  RunFile(std::string path, Descriptor descriptor)
      : path_(std::move(path)), descriptor_(std::move(descriptor)) {}
  Result<void> resume(const RunHeader& header);
  Result<void> begin(const RunHeader& header);
  Result<void> write(std::string_view bytes);

  std::string path_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
};

/// The items of all shares of one run, in the order of the run: one line of each share in turn.
/// Holds one line at a time.
class MergedRun {
 public:
  /// Errors, each naming the file: it is no run file; its run had other options; its share is there
  /// twice or incomplete; a share is missing.
  static Result<MergedRun> open(const std::vector<std::string>& paths);

  /// The header of the complete run.
  const RunHeader& header() const { return header_; }
  /// As RunLines.
  Result<std::optional<std::string_view>> next();
  std::string where() const { return shares_[at_].where(); }

 private:
  RunHeader header_;
  std::vector<RunLines> shares_;  ///< by their index
  std::uint64_t given_ = 0;
  std::uint64_t at_ = 0;  ///< the share of the line given last
};

}  // namespace ccdfuzz
