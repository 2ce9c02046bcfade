#pragma once

#include <array>
#include <span>

#include "base/verify.hpp"
#include "bezier/patch.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// The polar form (blossom) of a Bézier patch by de Casteljau steps, one argument a step.
/// points: shape.control_count() control points. arguments: one (u, v) a step; a curve or triangle
/// of degree n takes n of them; a tensor patch takes max(n, m), using the u of the first n and the
/// v of the first m. Equal arguments evaluate the patch there; arguments drawn from the corners of
/// a sub-domain give the control points of that sub-patch. Exact for exact S; for double the order
/// of operations is fixed: ((w·p_w + u·p_u) + v·p_v) for triangles, ((1−u)·p + u·q) else.
template <class S>
Vec3<S> blossom(const Shape& shape, std::span<const Vec3<S>> points,
                std::span<const Uv<S>> arguments) {
  CCDFUZZ_ASSERT(static_cast<int>(points.size()) == shape.control_count());
  std::array<Vec3<S>, kMaxControls> net;
  std::copy(points.begin(), points.end(), net.begin());
  const auto lerp = [](const Vec3<S>& p, const Vec3<S>& q, const S& s) {
    const S r(S(1) - s);
    Vec3<S> out;
    for (int k = 0; k < 3; ++k) out[k] = S(S(r * p[k]) + S(s * q[k]));
    return out;
  };
  switch (shape.kind) {
    case ShapeKind::kPoint:
      break;
    case ShapeKind::kCurve:
      for (int left = shape.n, step = 0; left > 0; --left, ++step) {
        for (int i = 0; i < left; ++i) net[i] = lerp(net[i], net[i + 1], arguments[step][0]);
      }
      break;
    case ShapeKind::kTriangle:
      for (int left = shape.n, step = 0; left > 0; --left, ++step) {
        const Shape from = Shape::triangle(left), to = Shape::triangle(left - 1);
        const S &u = arguments[step][0], &v = arguments[step][1];
        const S w(S(S(1) - u) - v);
        for (int i = 0; i < left; ++i) {
          for (int j = 0; j < left - i; ++j) {
            const Vec3<S>&pw = net[from.index(i, j)], &pv = net[from.index(i, j + 1)],
                  &pu = net[from.index(i + 1, j)];
            Vec3<S> out;
            for (int k = 0; k < 3; ++k) {
              out[k] = S(S(S(w * pw[k]) + S(u * pu[k])) + S(v * pv[k]));
            }
            net[to.index(i, j)] = out;  // to.index ≤ from.index of all later reads
          }
        }
      }
      break;
    case ShapeKind::kTensor:
      for (int i = 0; i <= shape.n; ++i) {
        Vec3<S>* row = &net[shape.index(i, 0)];
        for (int left = shape.m, step = 0; left > 0; --left, ++step) {
          for (int j = 0; j < left; ++j) row[j] = lerp(row[j], row[j + 1], arguments[step][1]);
        }
      }
      for (int left = shape.n, step = 0; left > 0; --left, ++step) {
        for (int i = 0; i < left; ++i) {
          net[shape.index(i, 0)] =
              lerp(net[shape.index(i, 0)], net[shape.index(i + 1, 0)], arguments[step][0]);
        }
      }
      break;
  }
  return net[0];
}

/// The point of the patch at (u, v).
template <class S>
Vec3<S> evaluate(const Shape& shape, std::span<const Vec3<S>> points, const Uv<S>& uv) {
  std::array<Uv<S>, kMaxDegree> arguments;
  arguments.fill(uv);
  return blossom<S>(shape, points, arguments);
}

/// The point of a moving patch at (u, v) and time t (Eq. 2).
template <class S>
Vec3<S> evaluate(const MovingPatch<S>& patch, const Uv<S>& uv, const S& t) {
  return evaluate<S>(patch.shape, patch.at(t), uv);
}

}  // namespace ccdfuzz
