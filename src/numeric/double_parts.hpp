#pragma once

#include <bit>
#include <cstdint>

namespace ccdfuzz {

/// The finite double mantissa·2^exponent with an odd mantissa, |mantissa| < 2^53; zero is 0·2^0.
struct DoubleParts {
  std::int64_t mantissa = 0;
  int exponent = 0;

  /// The least e with |x| < 2^e; meaningless for zero.
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

}  // namespace ccdfuzz
