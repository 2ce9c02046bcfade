#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "io/descriptor.hpp"

struct ZSTD_DCtx_s;

namespace ccdfuzz {

/// How a path's ending says its cases are stored.
enum class CaseFileKind { kJson, kJsonLines, kJsonLinesZstd };

/// What the ending of a path says; nullopt for one other than .json, .jsonl and .jsonl.zst.
std::optional<CaseFileKind> case_file_kind_by_name(const std::string& path);
/// The kind of a path. A stream (is_stream) of any name holds lines.
/// Errors: an ending other than .json, .jsonl and .jsonl.zst, naming the path.
Result<CaseFileKind> case_file_kind(const std::string& path);

/// For a path that no command line names but a file or a folder, where a pipe would block for ever.
/// Errors: what is there is not a regular file.
Result<void> refuse_irregular(const std::string& path);

/// Sorted paths of what is in a folder and in the folders in it. Links to folders are not followed.
/// is_left_out(name): true to skip that file or folder. Errors: a folder that cannot be read,
/// naming that one.
Result<std::vector<std::string>> files_under(
    const std::string& folder, const std::function<bool(const std::string& name)>& is_left_out);

/// Bytes of a file, from the start, a piece at a time; decompressed where it is zstd.
class InputBytes {
 public:
  /// Errors: it does not exist, is a folder, cannot be read, naming the path.
  static Result<InputBytes> open(const std::string& path, bool zstd);

  /// The next bytes, at most `most` of them; empty at the end of the file. Errors: naming the path.
  Result<std::string> read(size_t most);
  /// How many bytes of the file itself, which may be compressed, have been read.
  std::uint64_t position() const { return position_; }

 private:
  Result<std::string> read_as_it_is(size_t most);

  std::string path_;
  Descriptor descriptor_;
  std::uint64_t position_ = 0;
  /// Null: it is not compressed.
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> stream_{nullptr, nullptr};
  std::string packed_;  ///< read, and from `at_` on not yet unpacked
  size_t at_ = 0;
  bool ended_ = false;
  bool inside_frame_ = false;
};

}  // namespace ccdfuzz
