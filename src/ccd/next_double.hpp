#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ccdfuzz {

/// nextafter(x, ∞), without the call.
inline double next_up(double x) {
  if (x == 0) return std::numeric_limits<double>::denorm_min();
  if (!(std::abs(x) < std::numeric_limits<double>::infinity())) return std::nextafter(x, HUGE_VAL);
  const auto bits = std::bit_cast<std::int64_t>(x);
  return std::bit_cast<double>(x > 0 ? bits + 1 : bits - 1);
}

/// nextafter(x, −∞).
inline double next_down(double x) {
  return -next_up(-x);
}

}  // namespace ccdfuzz
