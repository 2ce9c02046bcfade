#pragma once

#include "case/query.hpp"

namespace ccdfuzz::exact_ccd {

/// Ends of windows are t = 0, t = t_max and the multiples of 2^grid in between. They have few
/// enough bits to keep exact predicates short. The grid is so fine that rounding a window outward
/// costs nothing that shows (2^-kGridBits of the horizon).
inline constexpr int kGridBits = 30;

/// How a query is written in integers. With P, V, t the input doubles,
///   p = P·2^-length, v = V·2^(time−length), T = t·2^-time
/// are integers for every coordinate and every window end t, and the point P + t·V is
/// 2^length·(p + T·v). With h the horizon below, h·2^horizon ≥ t_max.
struct Units {
  int length = 0;
  int time = 0;
  int grid = 0;            ///< exponent of the grid of window ends
  int horizon = 0;         ///< 0 ≤ t < 2^horizon for all t ≤ t_max
  int top = 0;             ///< no coordinate and no way until t_max reaches 2^top; 0 if all are 0
  int magnitude_bits = 0;  ///< |p + T·v| < 2^magnitude_bits, for 0 ≤ t ≤ t_max
  int degree_sum = 0;      ///< most midpoint halvings that one split applies to a control point

  static Units of(const Query& query);

  /// Bits of a two's complement integer that holds every intermediate result of the exact gap
  /// predicate (exact_scene.hpp). The cells are of the given depth, and the components of axes of
  /// magnitude ≤ 2^axis_bits.
  int bits_needed(int axis_bits, int depth) const {
    // Sum of three products with the axis: 2^(axis_bits)·3 < 2^(axis_bits+2). Each of the
    // degree_sum blossom steps forms a combination with non-negative weights of sum 2^depth, so it
    // multiplies the bound by 2^depth. Aligning the patch that takes fewer steps brings it to the
    // same scale. One bit for the sign.
    return magnitude_bits + (axis_bits + 2) + degree_sum * depth + 1;
  }
};

/// Blossom steps of a shape, each of which multiplies homogeneous coordinates by 2^depth.
constexpr int blossom_steps(const Shape& shape) {
  return shape.n + shape.m;
}

}  // namespace ccdfuzz::exact_ccd
