#pragma once

#include <algorithm>
#include <bit>
#include <compare>
#include <cstdint>

// Exact operations on a double, by its bits: nothing here depends on the floating-point
// environment. (A comparison of doubles does: a thread that flushes subnormals sees 2^-1074 == 0.)
namespace ccdfuzz {

constexpr bool is_finite(double x) {
  return (std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff) != 0x7ff;
}

constexpr bool is_nan(double x) {
  return std::bit_cast<std::uint64_t>(x) << 1 > std::uint64_t{0x7ff} << 53;
}

/// The order of two real numbers, ±infinity at the ends and −0 = 0. Requires neither to be NaN.
constexpr std::strong_ordering compare(double x, double y) {
  const auto place = [](double z) {
    const auto magnitude = std::bit_cast<std::int64_t>(z) & INT64_MAX;
    return std::bit_cast<std::int64_t>(z) < 0 ? -magnitude : magnitude;
  };
  return place(x) <=> place(y);
}

/// The finite double mantissa·2^exponent with an odd mantissa, |mantissa| < 2^53; zero is 0·2^0.
struct DoubleParts {
  std::int64_t mantissa = 0;
  int exponent = 0;

  /// The least e with |x| < 2^e; 0 of zero.
  constexpr int top() const {
    const auto magnitude = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
    return exponent + static_cast<int>(std::bit_width(magnitude));
  }

  friend constexpr bool operator==(const DoubleParts&, const DoubleParts&) = default;
};

/// Takes a finite double apart, exactly. Requires x finite.
constexpr DoubleParts parts_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t m = bits & 0xf'ffff'ffff'ffffULL;
  if (biased != 0) m |= std::uint64_t{1} << 52;
  if (m == 0) return {};
  const int zeros = std::countr_zero(m);
  m >>= zeros;
  // The unit in the last place is 2^(biased − 1075), and 2^-1074 for subnormals.
  const int exponent = (biased == 0 ? 1 : biased) - 1075 + zeros;
  return {bits >> 63 != 0 ? -static_cast<std::int64_t>(m) : static_cast<std::int64_t>(m), exponent};
}

/// The double mantissa·2^exponent. Requires that there is one, and |mantissa| ≤ 2^53. 2^53·2^971 is
/// infinity.
constexpr double double_of(std::int64_t mantissa, int exponent) {
  if (mantissa == 0) return 0;
  auto m = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
  const int unit = std::max(exponent + static_cast<int>(std::bit_width(m)) - 53, -1074);
  m = exponent >= unit ? m << (exponent - unit) : m >> (unit - exponent);
  // m < 2^53 units in the last place; its bit 52, if set, counts one up in the exponent's field.
  const std::uint64_t bits = (static_cast<std::uint64_t>(unit + 1074) << 52) + m;
  return std::bit_cast<double>(bits | (mantissa < 0 ? std::uint64_t{1} << 63 : 0));
}

}  // namespace ccdfuzz
