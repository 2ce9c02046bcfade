#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "query/case.hpp"

namespace ccdfuzz {

/// A case and where it was read: "path" of a .json, "path:line" of a .jsonl or .jsonl.zst.
struct NamedCase {
  std::string id;
  Case value;
  std::string file = {};  ///< beside which its trees are (trees_path); empty: it has none
};

/// No case comes near this; it bounds the memory that a wrong file takes.
inline constexpr size_t kMaxCaseBytes = 4 << 20;

/// Reads the cases of a file one after the other, holding one at a time. The ending says how they
/// are stored: .json (one case), .jsonl (one a line; blank lines and CR LF are fine), .jsonl.zst
/// (the same, compressed by zstd). A device or a pipe is read as .jsonl whatever its name.
class CaseReader {
 public:
  /// Errors: another ending, no such file, a folder, unreadable; naming the path.
  static Result<CaseReader> open(const std::string& path);
  CaseReader(CaseReader&&) noexcept;
  CaseReader& operator=(CaseReader&&) noexcept;
  ~CaseReader();

  /// The next case; nothing at the end. Errors: as parse_case, and a truncated or corrupt file, or
  /// one that holds no case at all; naming path and line. No reading on after an error.
  Result<std::optional<NamedCase>> next();

 private:
  struct State;
  explicit CaseReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Calls visit on every case of the file in order, until it gives an error.
Result<void> for_each_case(const std::string& path,
                           const std::function<Result<void>(NamedCase)>& visit);

/// All cases of the file at once.
Result<std::vector<NamedCase>> read_cases(const std::string& path);

/// Writes cases to a file, which appears whole with finish() or, if that is not reached, not at
/// all. Endings as for reading; a .json takes one case. Errors: another ending, a full disk, a
/// read-only folder, naming the path. No writing on after an error.
class CaseWriter {
 public:
  static Result<CaseWriter> open(const std::string& path);
  CaseWriter(CaseWriter&&) noexcept;
  CaseWriter& operator=(CaseWriter&&) noexcept;
  ~CaseWriter();

  Result<void> write(const Case& value);
  /// Must come last.
  Result<void> finish();

 private:
  struct State;
  explicit CaseWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace ccdfuzz
