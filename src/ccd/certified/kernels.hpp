#pragma once

#include <array>

namespace ccdfuzz::certified {

/// The arithmetic that tdibm-c spends its time on, each function built for every vector unit worth
/// it and chosen when the program starts. All builds round alike: the order of operations is that
/// of the source and nothing is fused, so the results do not depend on the machine.

/// Axes are handled four at once, one a lane.
inline constexpr int kLanes = 4;
using Lanes = std::array<double, kLanes>;

/// Component k of axis i at [k][i]. Lanes that no axis needs are zero: such an axis separates
/// nothing.
struct alignas(32) AxisBatch {
  std::array<Lanes, 3> axes{};
};

/// Extents on four axes at both ends of a window.
struct alignas(32) RangeBatch {
  Lanes min_lo, max_lo, min_hi, max_hi;
};

/// The control points of a net at both ends of a window: x, y, z at its start, x, y, z at its end,
/// each array `width` long, a multiple of 4; entries past `count` repeat the last control point.
struct Snapshot {
  const double* values;
  int width;
  int count;

  double at(int end, int k, int i) const { return values[(3 * end + k) * width + i]; }
};

/// p + t·v of every component at t0 and t1, product rounded first. net: positions x, y, z, then
/// velocities, each `width` long. out: 6·width places, as in Snapshot, aligned to 32 bytes.
void take_snapshot(const double* net, int width, double t0, double t1, double* out);

/// Least and greatest entry of each of the six arrays of a snapshot.
struct ComponentRanges {
  std::array<double, 6> min, max;
};
void component_ranges(const Snapshot& snapshot, ComponentRanges& out);

/// Extents of a snapshot on four axes; a height is (l₀x + l₁y) + l₂z.
void project(const Snapshot& snapshot, const AxisBatch& axes, RangeBatch& out);

/// The lines of a net on one axis: slope from the velocities, intercept from the positions, each as
/// a height above. slopes and intercepts: `width` places each.
void project_lines(const double* net, int width, const std::array<double, 3>& axis, double* slopes,
                   double* intercepts);

}  // namespace ccdfuzz::certified
