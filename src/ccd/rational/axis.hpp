#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "numeric/exact_scalars.hpp"

namespace ccdfuzz::exact_ccd {

/// A separating axis with few-bit integer components. It is not unit, and exact by definition,
/// since any vector serves as an axis: if h < 0 on it, the hulls are disjoint.
struct IntegerAxis {
  std::array<std::int32_t, 3> l{};

  /// |l|_1.
  std::int64_t norm1() const {
    std::int64_t sum = 0;
    for (const std::int64_t x : l) sum += x < 0 ? -x : x;
    return sum;
  }

  friend bool operator==(const IntegerAxis&, const IntegerAxis&) = default;
};

/// Bits of an axis at most. No fewer than kGridBits: then what its rounding takes from a start is
/// about a step of the grid, whatever the depth.
inline constexpr int kMostAxisBits = 30;

/// Bits of an axis for cells of a given depth. A cell of width 2^-d is about 2^-2d thick, so an
/// axis that is off by 2^-d blurs it by its own thickness. Flat patches are thinner, and need the
/// rest.
constexpr int axis_bits(int depth) {
  constexpr int kSpare = 16;
  return std::min(depth + kSpare, kMostAxisBits);
}

/// The integer vector with a largest component of magnitude 2^bits that is nearest in direction to
/// `direction`. Nothing if direction is not finite or smaller than 2^-900. Requires 1 ≤ bits ≤ 30.
std::optional<IntegerAxis> round_to_axis(const Vec3<double>& direction, int bits);

}  // namespace ccdfuzz::exact_ccd
