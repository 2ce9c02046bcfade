#pragma once

#include <array>
#include <vector>

#include "case/query.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz::certified {

/// Lower limit of the absolute error term. The true underflow error is smaller; a normal number is
/// used because arithmetic on subnormals is slow. Lengths are of the order of 1.
inline constexpr double kLeastAbsolute = 0x1p-1000;

/// A query brought to magnitude 1 by steps whose rounding is known. No finite input then
/// overflows later, and what underflows is below `absolute`. The error bound scales with the scene,
/// not with its distance from the origin. Nor does it with a common velocity, unless one patch
/// alone has ends. Laws C and L9 rest on the inequalities here.
///
/// Stored control point p' and the exact p'' = 2^space·(p − c), stored velocity v' and the exact
/// v'' = 2^(space+time)·(v − w), with c and w common to both patches, satisfy per component
///   |p' − p''| ≤ u·|p''| + absolute,   |v' − v''| ≤ u·|v''| + absolute,   u = 2^-53,
/// but where a patch has ends (MovingPatch), the second is
///   t'·|v' − v''| ≤ 2u·(|p''| + |v''|) + t'·absolute.
/// Time is t' = t / 2^time in [0, t_max]; t_max in [½, 1), or 0. A common c + t·w moves both
/// patches alike, so contacts and their times are those of the query.
struct NormalisedQuery {
  std::array<Shape, 2> shapes;
  /// Component k = 0..2 of position i at [side][i][k], of velocity at [side][i][k + 3].
  std::array<std::vector<std::array<double, 6>>, 2> controls;
  /// The weights of a rational patch times 2^weight_shift, exactly; the largest is in [1, 2). Other
  /// patches have none.
  std::array<std::vector<double>, 2> weights;
  std::array<int, 2> weight_shift{};
  double t_max = 0;
  int time = 0;   ///< a binary exponent: t = t'·2^time
  int space = 0;  ///< lengths are scaled by 2^space
  /// Σ over sides of max|p'| + max|v'|, three sums rounded to nearest (the M of DERIVATION.md).
  double magnitude = 0;
  /// The query's separation, scaled, rounded up.
  double separation = 0;
  /// What ends add to the roundings behind a control point at any time: Laws C and L9 count them.
  int roundings = 0;
  /// The absolute part of the error above, ≥ kLeastAbsolute. Infinite if scaling down by 4 may have
  /// lost all relative positions (some coordinates near 2^1023 and equal, the differences
  /// subnormal). Then no pair is ever separated.
  double absolute = 0;
};

/// Keeps the memory of `out`.
void normalise(const Query& query, NormalisedQuery& out);

/// The largest double ≤ t'·2^time.
double original_time(double t, int time);

}  // namespace ccdfuzz::certified
