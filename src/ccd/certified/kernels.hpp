#pragma once

#include <array>

#include "ccd/certified/midpoint_program.hpp"
#include "ccd/certified/provenance.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz::certified {

/// The hot arithmetic of tdibm-c, compiled for SSE2 and AVX2 and selected at load time. All builds
/// round alike: the order of operations is that of the source, and nothing is fused. So the results
/// do not depend on the machine.

/// Axes are handled four at once, one a lane.
inline constexpr int kLanes = 4;
using Lanes = std::array<double, kLanes>;

/// Component k of axis i at [k][i]. Lanes that no axis needs are zero: such an axis separates
/// nothing, since all of its heights are 0 and its bound is not below 0.
struct alignas(32) AxisBatch {
  std::array<Lanes, 3> axes{};
};

/// Extents on four axes at both ends of a window.
struct alignas(32) RangeBatch {
  Lanes min_lo, max_lo, min_hi, max_hi;
  [[no_unique_address]] Provenance of;
};

/// Error bounds on four axes: E of Law C, and what a separation adds to it.
struct Bounds {
  Lanes on;
  [[no_unique_address]] Basis made_from;
};

/// Places of a control point in a net or a snapshot: two vectors x, y, z, 0. In a net of a rational
/// patch the fourth place is the weight w of w·x, w·y, w·z; in other nets, and for velocities, 0.
inline constexpr int kPerPoint = 8;
inline constexpr int kWeightPlace = 3;

/// The control points of a net at both ends of a window: of each, its place at the start and at the
/// end.
struct Snapshot {
  const double* values;
  int count;
  [[no_unique_address]] Provenance of{};

  double at(int end, int k, int i) const { return values[kPerPoint * i + 4 * end + k]; }
};

/// p + t·v of every control point at t0 and t1, product rounded first. net: of each control point
/// its position, then its velocity. out: kPerPoint·count places, as in Snapshot. The weight of
/// a rational patch divides the sum.
/// ranges, if given, get the extents on the coordinate axes in the first three lanes, and zeros in
/// the last: count ≥ 1. An extent starts from the first point. That requires finite numbers, as
/// NormalisedQuery has: beside a NaN at t0, compare would see t1 alone.
void take_snapshot(const double* net, int count, double t0, double t1, double* out,
                   RangeBatch* ranges = nullptr);

/// The nets of all children of a net of `count` control points, one after the other, by means of
/// the program's slots.
void split_net(const MidpointProgram& program, const double* net, int count, double* slots,
               double* children);

/// Extents of a snapshot on four axes; a point's height is (l₀x + l₁y) + l₂z. Law C counts its
/// roundings.
void project(const Snapshot& snapshot, const AxisBatch& axes, RangeBatch& out);

/// Which of four axes separate two nets in a window by more than the bound: bit i for axis i.
struct SeparatingAxes {
  unsigned throughout = 0;  ///< at both ends, with the same net below (Laws A and C)
  unsigned at_an_end = 0;   ///< at one end at least (Law C)
};
/// Requires extents at the ends of one window, and bounds made for the roundings of both.
SeparatingAxes compare(const RangeBatch& a, const RangeBatch& b, const Bounds& bounds);

/// Both extents on four axes, and which axes separate.
SeparatingAxes project_and_compare(const Snapshot& a, const Snapshot& b, const AxisBatch& axes,
                                   const Bounds& bounds, std::array<RangeBatch, 2>& ranges);

/// Bit 4·i + j for every pair of a[i] and b[j] that no axis separates throughout (Laws A and C).
/// Only `pairs` are looked at.
unsigned not_separated(const RangeBatch* a, const RangeBatch* b, unsigned pairs,
                       const Bounds& bounds);

}  // namespace ccdfuzz::certified
