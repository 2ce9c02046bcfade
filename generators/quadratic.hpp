#pragma once

#include <array>

#include "bezier/bernstein.hpp"
#include "bezier/blossom.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The triangular quadratic patch in barycentric terms, as the generators need it. The corners are
/// 0, 1, 2 where u, v, w = 1, and a control point belongs to a pair of corners {a, b}. The patch is
/// Σ x_a x_b c_ab over all ordered pairs. This is a quadratic form in x = (u, v, w) with the
/// control points as its symmetric 3×3 matrix.

inline constexpr Shape kQuadratic = Shape::triangle(2);

using Barycentric = std::array<Dyadic, 3>;

/// The two corners of each control point, in Shape's order: w², vw, v², uw, uv, u².
inline constexpr std::array<std::array<int, 2>, 6> kCornerPairs = {
    {{2, 2}, {1, 2}, {1, 1}, {0, 2}, {0, 1}, {0, 0}}};

/// Place in Shape's order of the control point of corners a and b.
constexpr size_t control_of(int a, int b) {
  constexpr std::array<std::array<size_t, 3>, 3> place = {{{5, 4, 3}, {4, 2, 1}, {3, 1, 0}}};
  return place[static_cast<size_t>(a)][static_cast<size_t>(b)];
}

/// The Bernstein weights of the six control points at x.
inline std::vector<Dyadic> bernstein_weights(const Barycentric& x) {
  return bernstein_weights<Dyadic>(kQuadratic, {x[0], x[1]});
}

/// The patch's point at x.
inline Vec3<Dyadic> point_at(const Points<Dyadic>& points, const Barycentric& x) {
  return evaluate<Dyadic>(kQuadratic, points, {x[0], x[1]});
}

/// The place of the largest magnitude; the first of equal ones.
inline int largest_component(const Vec3<Dyadic>& v) {
  int k = 0;
  for (int i = 1; i < 3; ++i) k = abs(v[i]) > abs(v[k]) ? i : k;
  return k;
}

inline Uv<Rational> uv_of(const Barycentric& x) {
  return {x[0].rational(), x[1].rational()};
}

}  // namespace ccdfuzz
