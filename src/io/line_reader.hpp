#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/input_bytes.hpp"

namespace ccdfuzz {

/// The lines of a file one after the other, holding one at a time.
class LineReader {
 public:
  /// Lines longer than `longest` bytes, and with `whole` files, are refused: it bounds the memory
  /// that a wrong file takes. Errors: as InputBytes::open.
  static Result<LineReader> open(const std::string& path, bool zstd, size_t longest);

  /// The text up to the next newline, or up to the end of the file if `whole`; nothing if no text
  /// is left. Valid until the next call. Errors: as InputBytes; a line that is too long.
  Result<std::optional<std::string_view>> next(bool whole = false);

  /// True iff a newline followed the text that next gave last.
  bool is_ended() const { return is_line_ended_; }
  /// The number of the line that next gave last, from 1 on; 0 before.
  size_t line() const { return line_; }
  /// "path:line" of that line.
  std::string here() const { return path_ + ":" + std::to_string(line_); }
  const std::string& path() const { return path_; }
  /// How many bytes of the file, which may be compressed, have been read.
  std::uint64_t position() const { return bytes_.position(); }

 private:
  std::string path_;
  InputBytes bytes_;
  size_t longest_ = 0;
  std::string buffer_;  ///< read, and from `at_` on not yet given out
  size_t at_ = 0;
  size_t line_ = 0;
  bool is_line_ended_ = false;
  bool ended_ = false;  ///< no more bytes beyond the buffer
};

/// All of a file that is not compressed. Errors: as InputBytes::open; it has more than `most`
/// bytes.
Result<std::string> read_text(const std::string& path, size_t most);
/// The same of one that no command line names. Errors: also as refuse_irregular.
Result<std::string> read_file(const std::string& path, size_t most);

/// The text without blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

}  // namespace ccdfuzz
