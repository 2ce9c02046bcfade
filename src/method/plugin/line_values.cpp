#include "method/plugin/line_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "io/json_real.hpp"
#include "io/json_write.hpp"

namespace ccdfuzz {

namespace {

constexpr const char* kFrom = "its answer";

/// Python and others write these where JSON has no word for them.
std::string with_quoted_non_finite(const std::string& line) {
  std::string out;
  bool in_string = false;
  for (size_t i = 0; i < line.size();) {
    if (line[i] == '"' && (i == 0 || line[i - 1] != '\\')) in_string = !in_string;
    size_t length = 0;
    for (const char* word : {"NaN", "-Infinity", "Infinity"}) {
      if (!in_string && length == 0 && line.compare(i, std::strlen(word), word) == 0) {
        length = std::strlen(word);
      }
    }
    if (length > 0) {
      out += fmt::format("\"{}\"", line.substr(i, length));
      i += length;
    } else {
      out += line[i++];
    }
  }
  return out;
}

}  // namespace

tl::unexpected<Fault> answer_fault(const std::string& name, const std::string& note) {
  return tl::unexpected(Fault{name, note});
}

tl::unexpected<Fault> garbage_answer(const std::string& note) {
  return answer_fault("garbage", note);
}

tl::expected<JsonValue, Fault> parse_object(const std::string& line) {
  Result<JsonValue> parsed = parse_json(line, kFrom);
  if (!parsed) parsed = parse_json(with_quoted_non_finite(line), kFrom);
  if (!parsed) {
    return garbage_answer(fmt::format("{}: {}", parsed.error().message(), line.substr(0, 80)));
  }
  if (parsed->kind != JsonKind::kObject)
    return garbage_answer("is no object: " + line.substr(0, 80));
  return *std::move(parsed);
}

std::string text_of(const JsonValue& object, std::string_view key) {
  const JsonValue* found = object.find(key);
  return found != nullptr && found->kind == JsonKind::kString ? found->text : "";
}

std::optional<double> number_of(const JsonValue* value) {
  if (value == nullptr) return std::nullopt;
  if (value->kind == JsonKind::kString) {
    std::string word = value->text;
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf" || word == "infinity") return std::numeric_limits<double>::infinity();
    if (word == "-inf" || word == "-infinity") return -std::numeric_limits<double>::infinity();
  }
  const Result<double> real = parse_real(*value);
  return real ? std::optional(*real) : std::nullopt;
}

std::optional<std::uint64_t> whole_of(const JsonValue* value) {
  const std::optional<double> number = number_of(value);
  if (!number || !(*number >= 0 && *number < 0x1p63)) return std::nullopt;
  const auto whole = static_cast<std::uint64_t>(*number);
  return static_cast<double>(whole) == *number ? std::optional(whole) : std::nullopt;
}

std::string any_number(double x) {
  return std::isfinite(x) ? json_number(x) : fmt::format("\"{}\"", x);
}

bool is_given(const JsonValue* value) {
  return value != nullptr && value->kind != JsonKind::kNull;
}

tl::expected<void, Fault> read_count(const JsonValue& object, std::string_view key,
                                     std::uint64_t& out) {
  const JsonValue* value = object.find(key);
  if (!is_given(value)) return {};
  const std::optional<std::uint64_t> count = whole_of(value);
  if (!count) {
    return garbage_answer(
        fmt::format("says {} {}, which is no whole number in [0, 2^63)", key, shown(*value)));
  }
  out = *count;
  return {};
}

tl::expected<bool, Fault> read_measure(const JsonValue& object, std::string_view key, double most,
                                       double& out) {
  const JsonValue* value = object.find(key);
  if (!is_given(value)) return false;
  const std::optional<double> number = number_of(value);
  if (!number || *number < 0 || *number > most) {
    return garbage_answer(
        fmt::format("says {} {}, which is no number in [0, {}]", key, shown(*value), most));
  }
  if (std::isnan(*number)) return false;
  out = *number;
  return true;
}

}  // namespace ccdfuzz
