#include "io/json_real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>

#include "base/double_parts.hpp"
#include "base/fp_guard.hpp"
#include "base/read_double.hpp"
#include "base/verify.hpp"
#include "io/json_write.hpp"

namespace ccdfuzz {

namespace {

Result<double> refuse(const JsonValue& value, std::string_view why) {
  return input_error("", fmt::format("{} {}", shown(value), why));
}

/// A decimal without its sign: 0.DIGITS · 10^exponent, the first and the last digit not 0. Zero has
/// no digits.
struct Decimal {
  std::string digits;
  long exponent = 0;

  friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// Requires the text of a JSON number. How many digits it has before zeros at the end go is in
/// `written`.
Decimal decimal_of(std::string_view text, size_t* written = nullptr) {
  Decimal out;
  const size_t mark = std::min(text.find_first_of("eE"), text.size());
  bool after_point = false;
  for (const char c : text.substr(0, mark)) {
    if (c == '.') after_point = true;
    if (c < '0' || '9' < c) continue;
    const bool leading_zero = out.digits.empty() && c == '0';
    if (!leading_zero) out.digits += c;
    if (!after_point && !leading_zero) ++out.exponent;
    if (after_point && leading_zero) --out.exponent;
  }
  if (written != nullptr) *written = out.digits.size();
  out.digits.erase(out.digits.find_last_not_of('0') + 1);
  if (out.digits.empty()) return {};
  if (mark < text.size()) {
    std::string_view power = text.substr(mark + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    long value = 0;
    std::from_chars(power.data(), power.data() + power.size(), value);
    out.exponent += value;
  }
  return out;
}

/// All digits of a finite double.
Decimal exact_decimal(double x) {
  const FpGuard guard;                      // std::to_chars compares x with 0
  constexpr int kMostDigits = 767;          // of the largest subnormal; no double has more
  std::array<char, kMostDigits + 16> text;  // with sign, point and exponent
  const auto [end, status] =
      std::to_chars(text.begin(), text.end(), x, std::chars_format::scientific, kMostDigits - 1);
  CCDFUZZ_VERIFY(status == std::errc());
  return decimal_of({text.begin(), end});
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
  constexpr int kBitsOfAnyInteger = 53;
  if (is_integer && parts_of(x).top() > kBitsOfAnyInteger && exact_decimal(x) != decimal_of(text)) {
    return refuse(value, "is an integer that no double equals");
  }
  return x;
}

constexpr auto kNotHex = "is not a hex float such as \"0x1.8p-3\"; a decimal number has no quotes";

/// The exponent in "p[±]D", or nothing of an empty text. Errors: it is none, or far out of range.
Result<long> parse_power(const JsonValue& value, std::string_view text) {
  if (text.empty()) return 0;
  text.remove_prefix(1);
  const bool plus = text.starts_with('+');
  if (plus) text.remove_prefix(1);
  long power = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), power);
  const bool is_whole = end == text.data() + text.size() && status != std::errc::invalid_argument;
  if (!is_whole || (plus && text.starts_with('-')))
    return tl::unexpected(refuse(value, kNotHex).error());
  constexpr long kFarOut = 1'000'000;  // no digits that fit a number's text lead back from there
  if (status != std::errc() || power < -kFarOut || kFarOut < power) {
    return tl::unexpected(refuse(value, "is out of the range of a double").error());
  }
  return power;
}

/// [-]0xH[.H][p[±]D], exactly.
Result<double> parse_hex(const JsonValue& value) {
  std::string_view text = value.text;
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return refuse(value, kNotHex);
  text.remove_prefix(2);

  const size_t mark = std::min(text.find_first_of("pP"), text.size());
  CCDFUZZ_TRY(long exponent, parse_power(value, text.substr(mark)));
  std::string digits(text.substr(0, mark));
  if (const size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= 4 * static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (digits.empty() || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    return refuse(value, kNotHex);
  }
  const size_t last = digits.find_last_not_of('0');
  if (last == std::string::npos) return negative ? -0.0 : 0.0;
  exponent += 4 * static_cast<long>(digits.size() - last - 1);
  const size_t first = digits.find_first_not_of('0');
  digits = digits.substr(first, last - first + 1);
  // 53 bits reach over 14 digits at most, whose first and last have one bit or more.
  std::uint64_t mantissa = 0;
  if (digits.size() > 14) return refuse(value, "is not exactly a double");
  std::from_chars(digits.data(), digits.data() + digits.size(), mantissa, 16);
  const int zeros = std::countr_zero(mantissa);
  mantissa >>= zeros;
  exponent += zeros;
  const int bits = static_cast<int>(std::bit_width(mantissa));
  // From 2^-1074, the least subnormal, to below 2^1024.
  if (bits > 53 || exponent < -1074 || exponent + bits > 1024) {
    return refuse(value, "is not exactly a double");
  }
  const auto m = static_cast<std::int64_t>(mantissa);
  return double_of(negative ? -m : m, static_cast<int>(exponent));
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

Result<double> parse_exact_real(const JsonValue& value) {
  const Result<double> x = parse_real(value);
  if (!x || value.kind != JsonKind::kNumber) return x;
  constexpr int kTelling = std::numeric_limits<double>::max_digits10;
  size_t written = 0;
  const Decimal decimal = decimal_of(value.text, &written);
  if (written <= kTelling || decimal == exact_decimal(*x)) return x;
  return refuse(value,
                fmt::format("is no double, and has more than the {} digits that tell doubles "
                            "apart; the nearest is {}",
                            kTelling, json_number(*x)));
}

}  // namespace ccdfuzz
