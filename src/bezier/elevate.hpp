#pragma once

#include "bezier/patch.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// The shape with a degree one higher: of a tensor patch that of v if `in_v`, else that of u. A
/// point becomes no valid shape.
constexpr Shape elevated(Shape shape, bool in_v) {
  ++(in_v && shape.kind == ShapeKind::kTensor ? shape.m : shape.n);
  return shape;
}

/// A patch whose control points are all multiplied by `times`.
template <class S>
struct Elevated {
  Shape shape;
  Points<S> points;
  int times;
};

/// The same patch in that shape. All points are multiplied by the new degree, which needs no
/// division; a point stays, times 1. Curve: (n+1)·b'_i = i·b_(i−1) + (n+1−i)·b_i; triangle:
/// (n+1)·b'_ijk = i·b_(i−1)jk + j·b_i(j−1)k + k·b_ij(k−1); tensor: as curves. Requires that degree
/// below kMaxDegree.
template <class S>
Elevated<S> elevated(const Shape& shape, const Points<S>& points, bool in_v = false) {
  if (shape.kind == ShapeKind::kPoint) return {shape, points, 1};
  in_v = in_v && shape.kind == ShapeKind::kTensor;
  const Shape to = elevated(shape, in_v);
  const int degree = in_v ? to.m : to.n;
  const Vec3<S> none{S(0), S(0), S(0)};
  Elevated<S> out{to, Points<S>(static_cast<size_t>(to.control_count()), none), degree};
  const bool is_triangle = shape.kind == ShapeKind::kTriangle;
  for_each_control(shape, [&](int i, int j) {
    const Vec3<S>& p = points[static_cast<size_t>(shape.index(i, j))];
    const auto give = [&](int to_i, int to_j, int weight) {
      Vec3<S>& sum = out.points[static_cast<size_t>(to.index(to_i, to_j))];
      for (int k = 0; k < 3; ++k) sum[k] += p[k] * S(weight);
    };
    const bool gives_in_u = !in_v, gives_in_v = in_v || is_triangle;
    if (gives_in_u) give(i + 1, j, i + 1);
    if (gives_in_v) give(i, j + 1, j + 1);
    give(i, j, degree - (gives_in_u ? i : 0) - (gives_in_v ? j : 0));
  });
  return out;
}

}  // namespace ccdfuzz
