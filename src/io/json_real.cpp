#include "io/json_real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/double_parts.hpp"
#include "base/read_double.hpp"
#include "base/verify.hpp"
#include "io/json_write.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

namespace {

tl::unexpected<InputError> refuse(const JsonValue& value, std::string_view why) {
  return input_error("", "{} {}", shown(value), why);
}

/// Takes the point out of digits, which are a whole number then. Returns how many stood behind it.
long drop_point(std::string& digits) {
  const size_t point = digits.find('.');
  if (point == std::string::npos) return 0;
  digits.erase(point, 1);
  return static_cast<long>(digits.size() - point);
}

/// How many digits a decimal has, from the first that is not 0 on.
size_t significant_digits(std::string_view text) {
  text = text.substr(0, text.find_first_of("eE"));
  text.remove_prefix(std::min(text.find_first_of("123456789"), text.size()));
  return text.size() - static_cast<size_t>(std::ranges::count(text, '.'));
}

/// What the text of a JSON number says. Requires a magnitude in the range of doubles, above 0.
Rational exact_decimal(std::string_view text) {
  const size_t mark = std::min(text.find_first_of("eE"), text.size());
  std::string digits(text.substr(0, mark));
  std::string_view power = text.substr(std::min(mark + 1, text.size()));
  if (power.starts_with('+')) power.remove_prefix(1);
  long exponent = 0;
  std::from_chars(power.data(), power.data() + power.size(), exponent);
  exponent -= drop_point(digits);
  Integer unit;
  mpz_ui_pow_ui(unit.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  const Rational whole(Integer(digits, 10));
  return exponent < 0 ? Rational(whole / unit) : Rational(whole * unit);
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
  if (is_integer && parts_of(x).top() > kBitsOfAnyInteger && exact(x) != exact_decimal(text)) {
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
  if (!is_whole || (plus && text.starts_with('-'))) return refuse(value, kNotHex);
  constexpr long kFarOut = 1'000'000;  // no digits that fit a number's text lead back from there
  if (status != std::errc() || power < -kFarOut || kFarOut < power) {
    return refuse(value, "is out of the range of a double");
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
  exponent -= 4 * drop_point(digits);
  if (digits.empty() || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
    return refuse(value, kNotHex);
  }
  const auto x = Dyadic(Integer(digits, 16), exponent).to_double_exactly();
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

Result<double> parse_exact_real(const JsonValue& value) {
  const Result<double> x = parse_real(value);
  if (!x || value.kind != JsonKind::kNumber) return x;
  constexpr int kTelling = std::numeric_limits<double>::max_digits10;
  const bool tells_one = significant_digits(value.text) <= kTelling;
  if (tells_one || exact_decimal(value.text) == exact(*x)) return x;
  return refuse(value,
                fmt::format("is no double, and has more than the {} digits that tell doubles "
                            "apart; the nearest is {}",
                            kTelling, json_number(*x)));
}

}  // namespace ccdfuzz
