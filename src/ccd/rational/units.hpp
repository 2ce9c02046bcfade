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
  int grid = 0;     ///< exponent of the grid of window ends
  int horizon = 0;  ///< 0 ≤ t < 2^horizon for all t ≤ t_max
  int top = 0;      ///< no coordinate and no way until t_max reaches 2^top; 0 if all are 0

  static Units of(const Query& query);
};

}  // namespace ccdfuzz::exact_ccd
