#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "bezier/blossom.hpp"
#include "bezier/patch.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// The control points of the part of a patch over `corners` (Appendix A (b)): the blossom of every
/// choice of corners, from scratch. corners as in Cell::corners, or any other of that form.
/// Exact for exact S; no allocation. out has shape.control_count() places and may not alias points.
template <class S>
void restrict_to(const Shape& shape, std::span<const Vec3<S>> points,
                 const std::array<Uv<S>, 3>& corners, std::span<Vec3<S>> out) {
  CCDFUZZ_ASSERT(static_cast<int>(out.size()) == shape.control_count());
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  const bool is_triangle = shape.kind == ShapeKind::kTriangle;
  // Control point (i, j) takes i arguments at the u end, j at the v end, the rest at the origin.
  std::array<Uv<S>, kMaxDegree> arguments;
  for_each_control(shape, [&](int i, int j) {
    for (int s = 0; s < std::max(shape.n, shape.m); ++s) {
      arguments[s] = is_triangle ? corners[corner_of_triangle(i, j, s)]
                                 : Uv<S>{corners[s < i ? 1 : 0][0], corners[s < j ? 1 : 0][1]};
    }
    out[shape.index(i, j)] = blossom<S>(shape, points, arguments);
  });
}

/// The whole moving patch restricted to corners, with velocities and without trim: a rational one
/// as w·p, w·v and w, which the new w then divides.
template <class S>
MovingPatch<S> restrict_to(const MovingPatch<S>& patch, const std::array<Uv<S>, 3>& corners) {
  MovingPatch<S> part = patch;
  part.trim.clear();
  if (!patch.is_rational()) part.weights.clear();
  const auto restrict_in_place = [&](Points<S>& points) {
    restrict_to<S>(patch.shape, Points<S>(points), corners, points);
  };
  multiply(part.positions, part.weights);
  multiply(part.velocities, part.weights);
  restrict_in_place(part.positions);
  restrict_in_place(part.velocities);
  if (part.weights.empty()) return part;
  Points<S> weights = as_points<S>(part.weights);
  restrict_in_place(weights);
  for (size_t i = 0; i < weights.size(); ++i) {
    part.weights[i] = weights[i][0];
    divide(part.positions[i], weights[i][0]);
    divide(part.velocities[i], weights[i][0]);
  }
  return part;
}

}  // namespace ccdfuzz
