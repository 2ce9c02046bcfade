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
#include "io/json_tree.hpp"

namespace ccdfuzz {

namespace {

/// The value on one line, with these marks behind an item and a key.
std::string on_one_line(const JsonValue& value, const char* comma, const char* colon) {
  if (value.kind == JsonKind::kString) return json_string(value.text);
  const bool is_object = value.kind == JsonKind::kObject;
  if (!is_object && value.kind != JsonKind::kArray) return value.text;
  std::string out(1, is_object ? '{' : '[');
  for (size_t i = 0; i < value.items.size(); ++i) {
    if (i > 0) out += comma;
    if (is_object) out += json_string(value.keys[i]) + colon;
    out += on_one_line(value.items[i], comma, colon);
  }
  return out + (is_object ? '}' : ']');
}

/// The value, which begins in `column` of a line with this indent.
std::string laid_out(const JsonValue& value, size_t indent, size_t column) {
  constexpr size_t kColumns = 100;
  // Blanks after commas and colons come on top of what is counted, a few a line.
  const bool fits = column + on_one_line(value, ",", ":").size() < kColumns;
  if (fits || value.items.empty()) return on_one_line(value, ", ", ": ");
  const bool is_object = value.kind == JsonKind::kObject;
  std::string out(1, is_object ? '{' : '[');
  for (size_t i = 0; i < value.items.size(); ++i) {
    const std::string key = is_object ? json_string(value.keys[i]) + ": " : "";
    out += (i == 0 ? "\n" : ",\n") + std::string(indent + 2, ' ') + key;
    out += laid_out(value.items[i], indent + 2, indent + 2 + key.size());
  }
  return out + '\n' + std::string(indent, ' ') + (is_object ? '}' : ']');
}

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
  return laid_out(value_or_throw(parse_json(json, "")), 0, 0);
}

}  // namespace ccdfuzz
