#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "files/query_csv.hpp"
#include "io/input_bytes.hpp"
#include "io/output_file.hpp"

struct ZSTD_CCtx_s;

namespace ccdfuzz {

/// A case and where it was read: "path" of a .json, "path:line" of any other file.
struct NamedCase {
  std::string id;
  Case value;
  std::string file = {};                      ///< that it was read from; empty: from none
  std::shared_ptr<const CsvQuery> rows = {};  ///< what a query CSV says, which has no proof of it
  double share = 0;  ///< how much of the files of its CaseStream had been read then, in [0, 1]
};

/// How large the files are that the cases of a run came from: compressed, a case may take a byte.
class SourceBytes {
 public:
  /// The next case of the run.
  void add(const NamedCase& named);
  /// each · bytes, at least 1; no limit where a case came from a pipe or was never in a file.
  std::uint64_t times(std::uint64_t each) const;

 private:
  std::string file_;  ///< where the last case came from
  std::uint64_t bytes_ = 0;
  bool is_known_ = true;
};

/// No case comes near this, which is 1 MiB besides a miss tree in hex digits. It bounds the memory
/// that a wrong file takes.
inline constexpr size_t kMaxCaseBytes = (1 << 20) + 2 * MissTree::kMaxBytes;

/// How the names of files end that say what the cases of a data set beside them cost to make.
inline constexpr std::string_view kCostsEnding = ".generation.jsonl";

/// The files that the paths name: of a folder all .csv files in it and in its folders, by name.
/// Where others are named too, as by *.jsonl, files of costs are left out.
/// Errors: a folder that cannot be read or has none, naming it.
Result<std::vector<std::string>> case_files(const std::vector<std::string>& paths);

class CaseFile;

/// The cases of several files (case_files) one after the other, holding one at a time. The ending
/// says how they are stored. .json: one case. .jsonl: one per line; CR LF and up to 1,000 blank
/// lines are accepted. .jsonl.zst: the same, compressed by zstd. .csv: a query CSV, whose cases
/// have no truth. A device or a pipe is read as .jsonl whatever its name.
class CaseStream {
 public:
  explicit CaseStream(const std::vector<std::string>& paths, CsvOptions csv = {});
  ~CaseStream();

  /// The next case; nothing at the end. Errors: as case_files; another ending, no such file, a
  /// folder, unreadable, truncated, corrupt, or without any case; as parse_case, CsvReader and
  /// to_query; naming path and line. No reading on after an error.
  Result<std::optional<NamedCase>> next();

 private:
  Result<std::vector<std::string>> paths_;
  CsvOptions csv_;
  size_t index_ = 0;  ///< the file being read
  std::unique_ptr<CaseFile> file_;
  std::uint64_t size_ = 0, size_before_ = 0;  ///< all files; those before it
};

/// The only case of a file. Errors: as CaseStream; there are more.
Result<NamedCase> read_case(const std::string& path);

/// Writes cases to a file, which appears whole with finish() or, if that is not reached, not at
/// all. Endings as for reading; a .json takes one case. Errors: another ending, a full disk, a
/// read-only folder, naming the path. No writing on after an error.
class CaseWriter {
 public:
  static Result<CaseWriter> open(const std::string& path);

  Result<void> write(const Case& value);
  /// Writes all but the name, so that a file beside it may appear first. Nothing is written after.
  /// Errors also: a .json of no case.
  Result<void> complete();
  /// Must come last. Errors: as complete.
  Result<void> finish();

 private:
  explicit CaseWriter(OutputFile file) : file_(std::move(file)) {}
  Result<void> flush(bool last);

  std::string path_;
  CaseFileKind kind_ = CaseFileKind::kJson;
  OutputFile file_;
  size_t piece_ = 0;  ///< as much is handed on at once; of a stream each case as it comes
  std::string pending_;
  size_t written_ = 0;
  /// Null: it is not compressed.
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> zstd_{nullptr, nullptr};
  bool is_complete_ = false;
};

}  // namespace ccdfuzz
