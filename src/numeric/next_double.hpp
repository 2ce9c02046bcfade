#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// nextafter(x, ∞), without the call, by bits.
inline double next_up(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  constexpr auto kInfinity = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  const std::int64_t magnitude = bits & std::numeric_limits<std::int64_t>::max();
  if (magnitude == 0) return std::numeric_limits<double>::denorm_min();
  if (magnitude > kInfinity || bits == kInfinity) return x;
  return std::bit_cast<double>(bits > 0 ? bits + 1 : bits - 1);
}

/// nextafter(x, −∞).
inline double next_down(double x) {
  return -next_up(-x);
}

}  // namespace ccdfuzz
