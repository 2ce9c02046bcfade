#include "base/number_text.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "base/fp_guard.hpp"
#include "base/read_double.hpp"

namespace ccdfuzz {

namespace {

/// Reads one term from the front of `rest`, without a sign, and drops it from there.
std::optional<double> take_term(std::string_view& rest) {
  const char* const begin = rest.data();
  const char* const end = begin + rest.size();
  double value = 0;
  const char* after = nullptr;
  if (rest.starts_with("2^")) {
    int exponent = 0;
    const auto read = std::from_chars(begin + 2, end, exponent);
    if (read.ec != std::errc()) return std::nullopt;
    value = std::ldexp(1.0, exponent);
    if (value == 0) return std::nullopt;
    after = read.ptr;
  } else {
    const bool hex = rest.starts_with("0x") || rest.starts_with("0X");
    const char* const digits = begin + (hex ? 2 : 0);
    if (digits != end && *digits == '-') return std::nullopt;  // read_double would take it
    const auto read = read_double(digits, end, value, hex);
    if (read.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
    after = read.ptr;
  }
  rest.remove_prefix(static_cast<size_t>(after - begin));
  return value;
}

}  // namespace

Result<double> parse_number(const std::string& where, const std::string& text) {
  const FpGuard guard;
  const auto refuse = [&] {
    return input_error(where,
                       "\"{}\" is not a number such as 0.5, 1e-6, 2^-20 or "
                       "1+2^-30",
                       text);
  };
  std::string_view rest = text;
  double sum = 0;
  bool first = true;
  while (first || !rest.empty()) {
    double sign = 1;
    if (!rest.empty() && (rest[0] == '-' || (rest[0] == '+' && !first))) {
      sign = rest[0] == '-' ? -1 : 1;
      rest.remove_prefix(1);
    } else if (!first) {
      return refuse();
    }
    const std::optional<double> term = take_term(rest);
    if (!term) return refuse();
    const double before = std::exchange(sum, sum + sign * *term);
    if (!first && ((*term != 0 && sum == before) || (before != 0 && sum == sign * *term))) {
      return input_error(where, "\"{}\" is not a double: a term of it is lost by rounding", text);
    }
    first = false;
  }
  if (!std::isfinite(sum)) return refuse();
  return sum;
}

Result<double> parse_seconds(const std::string& where, const std::string& text) {
  return parse_number(where, text).and_then([&](double seconds) -> Result<double> {
    if (0 < seconds && seconds <= kMostSeconds) return seconds;
    return input_error(where, "{} is not in (0, {}]", text, kMostSeconds);
  });
}

Result<int> parse_power_of_two(const std::string& where, const std::string& text) {
  return parse_number(where, text).and_then([&](double value) -> Result<int> {
    int exponent = 0;
    if (!(value > 0) || std::frexp(value, &exponent) != 0.5) {
      return input_error(where, "\"{}\" is not a power of two such as 2^-20", text);
    }
    return exponent - 1;
  });
}

Result<std::uint64_t> parse_whole(const std::string& where, const std::string& text,
                                  std::uint64_t least, std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, status] = std::from_chars(text.data(), end, value);
  const bool octal_to_some = text.size() > 1 && text[0] == '0';
  const bool is_whole = status == std::errc() && rest == end && !octal_to_some;
  if (is_whole && least <= value && value <= most) return value;
  constexpr size_t kShown = 40;
  const bool has_limit = most < std::numeric_limits<std::uint64_t>::max();
  return input_error(where, "\"{}{}\" is not a whole number from {} to {}", text.substr(0, kShown),
                     text.size() > kShown ? "…" : "", least,
                     has_limit ? std::to_string(most) : "2^64 - 1");
}

Result<void> check_room(std::uint64_t first, std::uint64_t count, const char* things) {
  if (first <= std::numeric_limits<std::uint64_t>::max() - count) return {};
  return input_error("--first", "{} is too large: the last of {} {} would be above 2^64 - 2", first,
                     count, things);
}

}  // namespace ccdfuzz
