#pragma once

#include <vector>

#include "base/verify.hpp"
#include "bezier/patch.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// The Bernstein weights of a shape's control points at uv, in Shape's order: the point of the
/// patch there is the sum of weight·control point. They sum to 1. Exact for exact S.
template <class S>
std::vector<S> bernstein_weights(const Shape& shape, const Uv<S>& uv) {
  const auto power = [](const S& x, int n) {
    S y(1);
    for (int i = 0; i < n; ++i) y *= x;
    return y;
  };
  std::vector<S> weights;
  weights.reserve(static_cast<size_t>(shape.control_count()));
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
    case ShapeKind::kCurve:
    case ShapeKind::kTriangle: {
      const S rest(S(S(1) - uv[0]) - uv[1]);
      for_each_control(shape, [&](int i, int j) {
        weights.push_back(S(choose(shape.n, i) * choose(shape.n - i, j)) * power(uv[0], i) *
                          power(uv[1], j) * power(rest, shape.n - i - j));
      });
      break;
    }
    case ShapeKind::kTensor: {
      const std::vector<S> u = bernstein_weights<S>(Shape::curve(shape.n), {uv[0], S(0)});
      const std::vector<S> v = bernstein_weights<S>(Shape::curve(shape.m), {uv[1], S(0)});
      for (const S& a : u) {
        for (const S& b : v) weights.push_back(a * b);
      }
      break;
    }
  }
  return weights;
}

/// Where a rational curve or triangle of degree 1 has the point that the patch without weights has
/// at uv: barycentrics in proportion to x/w. uv itself of patches without weights.
template <class S>
Uv<S> parameters_with_weights(const Shape& shape, const std::vector<S>& weights, const Uv<S>& uv) {
  if (weights.size() < 2) return uv;
  CCDFUZZ_ASSERT(shape.n <= 1 && shape.kind != ShapeKind::kTensor);
  // Control points are at (0, 0), (0, 1) of a triangle, and (1, 0).
  const S at_origin(std::max(S(0), S(S(S(1) - uv[1]) - uv[0])) / weights[0]);
  const S at_v(shape.kind == ShapeKind::kTriangle ? S(uv[1] / weights[1]) : S(0));
  const S at_u(uv[0] / weights.back()), sum(S(at_origin + at_v) + at_u);
  if (!(sum > S(0))) return uv;  // outside of the patch
  return {S(at_u / sum), S(at_v / sum)};
}

}  // namespace ccdfuzz
