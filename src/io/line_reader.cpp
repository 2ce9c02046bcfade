#include "io/line_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ccdfuzz {

namespace {

constexpr size_t kBytesAtOnce = 1 << 16;

}  // namespace

Result<LineReader> LineReader::open(const std::string& path, bool zstd, size_t longest) {
  CCDFUZZ_TRY(auto bytes, InputBytes::open(path, zstd));
  LineReader reader;
  reader.path_ = path;
  reader.bytes_ = std::move(bytes);
  reader.longest_ = longest;
  return reader;
}

Result<std::optional<std::string_view>> LineReader::next(bool whole) {
  size_t searched = at_;
  for (;;) {
    const size_t newline = whole ? std::string::npos : buffer_.find('\n', searched);
    if (newline != std::string::npos || ended_) {
      if (newline == std::string::npos && at_ == buffer_.size()) return std::nullopt;
      const size_t end = std::min(newline, buffer_.size());
      const std::string_view text = std::string_view(buffer_).substr(at_, end - at_);
      at_ = std::min(end + 1, buffer_.size());
      is_line_ended_ = newline != std::string::npos;
      ++line_;
      return text;
    }
    if (buffer_.size() - at_ > longest_) {
      return input_error(whole ? path_ : fmt::format("{}:{}", path_, line_ + 1),
                         "is longer than {} bytes", longest_);
    }
    buffer_.erase(0, at_);
    at_ = 0;
    searched = buffer_.size();
    CCDFUZZ_TRY(auto more, bytes_.read(kBytesAtOnce));
    ended_ = more.empty();
    buffer_ += more;
  }
}

Result<std::string> read_text(const std::string& path, size_t most) {
  CCDFUZZ_TRY(auto file, LineReader::open(path, false, most));
  return file.next(true).map([](const auto& text) { return std::string(text.value_or("")); });
}

Result<std::string> read_file(const std::string& path, size_t most) {
  CCDFUZZ_TRY_VOID(refuse_irregular(path));
  return read_text(path, most);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

}  // namespace ccdfuzz
