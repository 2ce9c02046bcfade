#include "io/json_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/double_parts.hpp"
#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "io/json_library.hpp"

namespace ccdfuzz {

namespace {

/// The end of the string whose opening quote is at `at`: past its closing quote.
size_t end_of_string(std::string_view json, size_t at) {
  for (++at; json[at] != '"'; ++at) {
    if (json[at] == '\\') ++at;
  }
  return at + 1;
}

/// Lays out a JSON text without blanks between its tokens.
class Layout {
 public:
  explicit Layout(std::string_view json) : json_(json) {}

  /// Appends the value at `at_`, which begins in `column`; a member's value is followed by a comma.
  void value(size_t depth, size_t column) {
    const size_t end = end_of_value();
    constexpr size_t kColumns = 100;
    const bool is_container = json_[at_] == '{' || json_[at_] == '[';
    // Blanks after commas and colons come on top of what is counted, a few a line.
    if (!is_container || end - at_ < kColumns - std::min(column, kColumns - 1)) {
      return one_line(end);
    }
    out_ += json_[at_++];
    while (json_[at_ - 1] != '}' && json_[at_ - 1] != ']') {
      out_ += '\n';
      out_.append(2 * (depth + 1), ' ');
      size_t used = 2 * (depth + 1);
      if (json_[at_] == '"') {
        const size_t key_end = end_of_string(json_, at_);
        if (json_[key_end] == ':') {
          used += key_end - at_ + 2;
          out_ += json_.substr(at_, key_end - at_);
          out_ += ": ";
          at_ = key_end + 1;
        }
      }
      value(depth + 1, used);
      if (json_[at_] == ',') out_ += ',';
      ++at_;
    }
    out_ += '\n';
    out_.append(2 * depth, ' ');
    out_ += json_[at_ - 1];
  }

  std::string take() && { return std::move(out_); }

 private:
  size_t end_of_value() const {
    size_t at = at_, open = 0;
    do {
      const char c = json_[at];
      if (c == '"') {
        at = end_of_string(json_, at);
        continue;
      }
      if (c == '{' || c == '[') ++open;
      if (c == '}' || c == ']') {
        if (open == 0) break;
        --open;
      }
      if (c == ',' && open == 0) break;
      ++at;
    } while (at < json_.size());
    return at;
  }

  void one_line(size_t end) {
    while (at_ < end) {
      if (json_[at_] == '"') {
        const size_t string_end = end_of_string(json_, at_);
        out_ += json_.substr(at_, string_end - at_);
        at_ = string_end;
        continue;
      }
      out_ += json_[at_];
      if (json_[at_] == ',' || json_[at_] == ':') out_ += ' ';
      ++at_;
    }
  }

  std::string_view json_;
  size_t at_ = 0;
  std::string out_;
};

}  // namespace

std::string json_string(std::string_view text) {
  const bool stands_as_it_is = std::all_of(text.begin(), text.end(), [](char c) {
    return ' ' <= c && c <= '~' && c != '"' && c != '\\';
  });
  if (stands_as_it_is) return fmt::format("\"{}\"", text);
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_number(double x) {
  CCDFUZZ_VERIFY(is_finite(x));
  if (compare(x, 0) == 0) return std::signbit(x) ? "-0.0" : "0";  // many read -0 as an integer
  const FpGuard guard;                                            // std::to_chars compares x with 0
  std::array<char, 32> buffer;
  const auto [end, status] = std::to_chars(buffer.begin(), buffer.end(), x);
  CCDFUZZ_VERIFY(status == std::errc());
  return {buffer.begin(), end};
}

std::string readable_json(std::string_view json) {
  Layout layout(json);
  layout.value(0, 0);
  return std::move(layout).take();
}

}  // namespace ccdfuzz
