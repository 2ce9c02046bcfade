#pragma once

#include <array>

#include "bezier/patch.hpp"

namespace ccdfuzz {

template <class S>
struct Elevated {
  Shape shape;
  Points<S> points;
};

/// The same patch with each degree one higher; a point stays. With `multiply`, all points times
/// (n+1) (and (m+1) for a tensor patch), which needs no division: the same patch, larger.
/// Curve: (n+1)·b'_i = i·b_(i−1) + (n+1−i)·b_i; triangle: (n+1)·b'_ijk = i·b_(i−1)jk +
/// j·b_i(j−1)k + k·b_ij(k−1); tensor: as curves along u, then along v.
/// Requires degrees below kMaxDegree. S: Rational, or Dyadic with `multiply`.
template <class S>
Elevated<S> elevated(const Shape& shape, const Points<S>& points, bool multiply = false) {
  const auto share = [&](const S& weight, int degree) {
    if (multiply) return weight;
    if constexpr (std::is_same_v<S, Rational>) return S(weight / (degree + 1));
    return weight;
  };
  const auto add = [](Vec3<S>& to, const S& weight, const Vec3<S>& p) {
    for (int k = 0; k < 3; ++k) to[k] += S(weight * p[k]);
  };
  const Vec3<S> none{S(0), S(0), S(0)};
  switch (shape.kind) {
    case ShapeKind::kPoint:
      break;
    case ShapeKind::kCurve: {
      Elevated<S> out{Shape::curve(shape.n + 1), Points<S>(points.size() + 1, none)};
      for (int i = 0; i <= shape.n; ++i) {
        add(out.points[static_cast<size_t>(i + 1)], share(S(i + 1), shape.n), points[i]);
        add(out.points[static_cast<size_t>(i)], share(S(shape.n + 1 - i), shape.n), points[i]);
      }
      return out;
    }
    case ShapeKind::kTriangle: {
      const Shape to = Shape::triangle(shape.n + 1);
      Elevated<S> out{to, Points<S>(static_cast<size_t>(to.control_count()), none)};
      for (int i = 0; i <= shape.n; ++i) {
        for (int j = 0; j <= shape.n - i; ++j) {
          const Vec3<S>& p = points[static_cast<size_t>(shape.index(i, j))];
          const auto give = [&](int to_i, int to_j, int weight) {
            add(out.points[static_cast<size_t>(to.index(to_i, to_j))], share(S(weight), shape.n),
                p);
          };
          give(i + 1, j, i + 1);
          give(i, j + 1, j + 1);
          give(i, j, shape.n - i - j + 1);
        }
      }
      return out;
    }
    case ShapeKind::kTensor: {
      const Shape to = Shape::tensor(shape.n + 1, shape.m + 1);
      Elevated<S> out{to, Points<S>(static_cast<size_t>(to.control_count()), none)};
      for (int i = 0; i <= shape.n; ++i) {
        for (int j = 0; j <= shape.m; ++j) {
          for (int di = 0; di < 2; ++di) {
            for (int dj = 0; dj < 2; ++dj) {
              const S weight = share(S(di == 1 ? i + 1 : shape.n + 1 - i), shape.n) *
                               share(S(dj == 1 ? j + 1 : shape.m + 1 - j), shape.m);
              add(out.points[static_cast<size_t>(to.index(i + di, j + dj))], weight,
                  points[static_cast<size_t>(shape.index(i, j))]);
            }
          }
        }
      }
      return out;
    }
  }
  return {shape, points};
}

}  // namespace ccdfuzz
