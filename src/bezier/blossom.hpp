#pragma once

#include <array>
#include <span>

#include "base/verify.hpp"
#include "bezier/patch.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// The polar form (blossom) by de Casteljau steps in place, one argument a step. net holds
/// shape.control_count() control points of any type, and net[0] is the result.
/// on_line(p, q, step, in_v): between two neighbours, in direction v or u, at that step's argument.
/// on_triangle(w, u, v, step): of the three corners of a triangle.
/// A tensor patch takes steps in v for each u, then steps in u, each from 0.
template <class Control, class OnLine, class OnTriangle>
void blossom_in_place(const Shape& shape, std::span<Control> net, const OnLine& on_line,
                      const OnTriangle& on_triangle) {
  const auto at = [&](int place) -> Control& { return net[static_cast<size_t>(place)]; };
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  if (shape.kind == ShapeKind::kTriangle) {
    for (int left = shape.n, step = 0; left > 0; --left, ++step) {
      const Shape from = Shape::triangle(left), to = Shape::triangle(left - 1);
      for (int i = 0; i < left; ++i) {
        for (int j = 0; j < left - i; ++j) {
          // to.index ≤ from.index of all later reads
          at(to.index(i, j)) = on_triangle(at(from.index(i, j)), at(from.index(i + 1, j)),
                                           at(from.index(i, j + 1)), step);
        }
      }
    }
    return;
  }
  for (int i = 0; i <= shape.n; ++i) {
    const int row = shape.index(i, 0);
    for (int left = shape.m, step = 0; left > 0; --left, ++step) {
      for (int j = 0; j < left; ++j) {
        at(row + j) = on_line(at(row + j), at(row + j + 1), step, true);
      }
    }
  }
  for (int left = shape.n, step = 0; left > 0; --left, ++step) {
    for (int i = 0; i < left; ++i) {
      Control& p = at(shape.index(i, 0));
      p = on_line(p, at(shape.index(i + 1, 0)), step, false);
    }
  }
}

/// Which of a sub-domain's corners (Cell::corners) is argument `step` of its control point (i, j).
/// i arguments are the end of the local u axis, j that of v, the rest the origin.
constexpr int corner_of_triangle(int i, int j, int step) {
  return step < i ? 1 : step < i + j ? 2 : 0;
}

/// The blossom of points. arguments: one (u, v) a step; a curve or triangle of degree n takes n of
/// them; a tensor patch takes max(n, m), using the u of the first n and the v of the first m. Equal
/// arguments evaluate the patch there; arguments drawn from the corners of a sub-domain give the
/// control points of that sub-patch. Exact for exact S; for double the order of operations is
/// fixed: ((w·p_w + u·p_u) + v·p_v) for triangles, ((1−u)·p + u·q) else.
template <class S>
Vec3<S> blossom(const Shape& shape, std::span<const Vec3<S>> points,
                std::span<const Uv<S>> arguments) {
  CCDFUZZ_ASSERT(static_cast<int>(points.size()) == shape.control_count());
  std::array<Vec3<S>, kMaxControls> net;
  std::copy(points.begin(), points.end(), net.begin());
  blossom_in_place<Vec3<S>>(
      shape, net,
      [&](const Vec3<S>& p, const Vec3<S>& q, int step, bool in_v) {
        const S &s = arguments[static_cast<size_t>(step)][in_v ? 1 : 0], r(S(1) - s);
        Vec3<S> out;
        for (int k = 0; k < 3; ++k) out[k] = S(S(r * p[k]) + S(s * q[k]));
        return out;
      },
      [&](const Vec3<S>& pw, const Vec3<S>& pu, const Vec3<S>& pv, int step) {
        const auto& [u, v] = arguments[static_cast<size_t>(step)];
        const S w(S(S(1) - u) - v);
        Vec3<S> out;
        for (int k = 0; k < 3; ++k) out[k] = S(S(S(w * pw[k]) + S(u * pu[k])) + S(v * pv[k]));
        return out;
      });
  return net[0];
}

/// The point of the patch at (u, v).
template <class S>
Vec3<S> evaluate(const Shape& shape, std::span<const Vec3<S>> points, const Uv<S>& uv) {
  std::array<Uv<S>, kMaxDegree> arguments;
  arguments.fill(uv);
  return blossom<S>(shape, points, arguments);
}

/// Points times their weights, if there are any.
template <class S>
void multiply(Points<S>& points, const std::vector<S>& weights) {
  for (size_t i = 0; i < weights.size(); ++i) {
    for (int k = 0; k < 3; ++k) points[i][k] = S(weights[i] * points[i][k]);
  }
}

/// A homogeneous point over its weight. Numbers that have no quotient have no weights.
template <class S>
void divide(Vec3<S>& point, const S& weight) {
  if constexpr (requires { weight / weight; }) {
    for (int k = 0; k < 3; ++k) point[k] = S(point[k] / weight);
  } else {
    CCDFUZZ_VERIFY(false);
  }
}

/// Numbers as points that have them as their first coordinate.
template <class S>
Points<S> as_points(std::span<const S> numbers) {
  Points<S> out;
  for (const S& x : numbers) out.push_back({x, S(0), S(0)});
  return out;
}

/// The point at (u, v) of a patch with weights, or of one without.
template <class S>
Vec3<S> evaluate(const Shape& shape, Points<S> points, const std::vector<S>& weights,
                 const Uv<S>& uv) {
  multiply(points, weights);
  Vec3<S> point = evaluate<S>(shape, points, uv);
  if (weights.empty()) return point;
  divide(point, evaluate<S>(shape, as_points<S>(weights), uv)[0]);
  return point;
}

/// The point of a moving patch at (u, v) and time t (Eq. 2).
template <class S>
Vec3<S> evaluate(const MovingPatch<S>& patch, const Uv<S>& uv, const S& t) {
  return evaluate<S>(patch.shape, patch.at(t), patch.weights, uv);
}

}  // namespace ccdfuzz
