#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "numeric/double_parts.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/fp_guard.hpp"
#include "numeric/read_double.hpp"
#include "numeric/verify.hpp"
#include "query/json_tree.hpp"

namespace ccdfuzz {

namespace {

Result<double> refuse(const JsonValue& value, std::string_view why) {
  return input_error("", fmt::format("{} {}", shown(value), why));
}

Result<double> parse_decimal(const JsonValue& value) {
  const std::string& text = value.text;
  double x = 0;
  const auto [end, status] = read_double(text.data(), text.data() + text.size(), x);
  // Whatever is too large, and whatever is not 0 but would become it.
  if (status == std::errc::result_out_of_range || !is_finite(x)) {
    return refuse(value, "is out of the range of a double");
  }
  CCDFUZZ_VERIFY(status == std::errc() && end == text.data() + text.size());
  const bool is_integer = text.find_first_of(".eE") == std::string::npos;
  constexpr double kAllIntegersBelow = 0x1p53;
  if (is_integer && std::abs(x) >= kAllIntegersBelow && exact(x) != Rational(text)) {
    return refuse(value, "is an integer that no double equals");
  }
  return x;
}

/// The decimal's digits from the first that is not 0, without its point.
std::string significant_digits(std::string_view decimal) {
  std::string digits;
  for (const char c : decimal.substr(0, decimal.find_first_of("eE"))) {
    if (c >= (digits.empty() ? '1' : '0') && c <= '9') digits += c;
  }
  return digits;
}

/// The exact value of a decimal in a double's range.
Rational value_of_decimal(std::string_view decimal) {
  const size_t mark = std::min(decimal.find_first_of("eE"), decimal.size());
  const std::string_view mantissa = decimal.substr(0, mark);
  const std::string digits = significant_digits(mantissa);
  if (digits.empty()) return 0;
  long exponent = 0;
  if (mark < decimal.size()) {
    std::string_view power = decimal.substr(mark + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    std::from_chars(power.data(), power.data() + power.size(), exponent);
  }
  if (const size_t point = mantissa.find('.'); point != std::string_view::npos) {
    exponent -= static_cast<long>(mantissa.size() - point - 1);
  }
  Integer power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  const Rational magnitude =
      exponent < 0 ? Rational(Integer(digits), power) : Rational(Integer(digits) * power);
  return decimal.starts_with('-') ? Rational(-magnitude) : magnitude;
}

/// [-]0xH[.H][p[±]D], exactly.
Result<double> parse_hex(const JsonValue& value) {
  constexpr auto kNotHex = "is not a hex float such as \"0x1.8p-3\"";
  std::string_view text = value.text;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return refuse(value, kNotHex);
  text.remove_prefix(2);

  const size_t mark = std::min(text.find_first_of("pP"), text.size());
  std::string digits(text.substr(0, mark));
  std::string_view power = text.substr(mark);
  long exponent = 0;
  if (!power.empty()) {
    power.remove_prefix(1);
    if (power.starts_with('+')) power.remove_prefix(1);
    const auto [end, status] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (end != power.data() + power.size() || status == std::errc::invalid_argument ||
        text.substr(mark + 1).starts_with("+-")) {
      return refuse(value, kNotHex);
    }
    constexpr long kFarOut = 1'000'000;  // no digits that fit a file lead back from there
    if (status != std::errc() || std::abs(exponent) > kFarOut) {
      return refuse(value, "is out of the range of a double");
    }
  }
  if (const size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= 4 * static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  Integer mantissa;
  const bool all_hex = std::all_of(digits.begin(), digits.end(),
                                   [](unsigned char c) { return std::isxdigit(c) != 0; });
  if (digits.empty() || !all_hex || mantissa.set_str(digits, 16) != 0) {
    return refuse(value, kNotHex);
  }
  const auto x = Dyadic(mantissa, exponent).to_double_exactly();
  if (!x) return refuse(value, "is not exactly a double");
  return negative ? -*x : *x;
}

}  // namespace

Result<double> parse_real(const JsonValue& value) {
  if (value.text.size() > kMaxNumberLength) {
    return refuse(value, fmt::format("has {} characters; a number has at most {}",
                                     value.text.size(), kMaxNumberLength));
  }
  if (value.kind == JsonKind::kNumber) return parse_decimal(value);
  if (value.kind != JsonKind::kString) return refuse(value, "is not a number");
  std::string word = value.text;
  if (word.starts_with('-') || word.starts_with('+')) word.erase(0, 1);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* name : {"nan", "inf", "infinity"}) {
    if (word == name) return refuse(value, "is not finite");
  }
  return parse_hex(value);
}

Result<double> parse_case_real(const JsonValue& value) {
  const Result<double> x = parse_real(value);
  if (!x || value.kind != JsonKind::kNumber) return x;
  constexpr int kTelling = std::numeric_limits<double>::max_digits10;
  if (significant_digits(value.text).size() <= kTelling) return x;
  Rational exact_value = value_of_decimal(value.text);
  exact_value.canonicalize();
  if (exact_value == exact(*x)) return x;
  return refuse(value,
                fmt::format("is no double, and has more than the {} digits that tell doubles "
                            "apart; the nearest is {}",
                            kTelling, json_number(*x)));
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

}  // namespace ccdfuzz
