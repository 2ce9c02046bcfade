#pragma once

#include "bezier/shape.hpp"
#include "ccd/certified/pair_axes.hpp"
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

/// Candidate axis r of a pair of frames, 0 ≤ r < kPairAxes. The order is that in which they are
/// worth testing: both normals, the other box axes, the nine products of the two boxes' axes.
Vec3<double> pair_axis(const BoxDirections& a, const BoxDirections& b, int r);

/// Candidate axes of two cells at one time where contact is a distance (DERIVATION.md, 3): those of
/// tdibm-c, the offset of the middles first.
certified::CandidateAxes axes_apart(const std::array<Shape, 2>& shapes, const CellPoints& a,
                                    const CellPoints& b, double t);

}  // namespace ccdfuzz::exact_ccd
