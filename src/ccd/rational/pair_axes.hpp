#pragma once

#include "bezier/shape.hpp"
#include "ccd/rational/axis.hpp"
#include "ccd/rational/cell_points.hpp"

namespace ccdfuzz::exact_ccd {

/// The three mutually orthogonal directions of a cell's oriented box at one time (Appendix A (c)).
/// They are along the first parameter, normal to both parameters, and normal to these two.
/// Directions only: scaled to a largest component of 1. A cell that spans less than two directions
/// gets arbitrary ones for the rest. Double precision: a direction needs no error bound, see
/// IntegerAxis.
using BoxDirections = std::array<Vec3<double>, 3>;
BoxDirections box_directions(const Shape& shape, const CellPoints& points, double t);

inline constexpr int kPairAxes = 15;

/// From the middle of one cell to that of the other, at t. Cells that are small beside a separation
/// have no better one.
Vec3<double> offset_axis(const CellPoints& a, const CellPoints& b, double t);

/// Candidate axis r of a pair of frames, 0 ≤ r < kPairAxes. The order is that in which they are
/// worth testing: both normals, the other box axes, the nine products of the two boxes' axes.
Vec3<double> pair_axis(const BoxDirections& a, const BoxDirections& b, int r);

}  // namespace ccdfuzz::exact_ccd
