#pragma once

#include "generators/quadratic.hpp"

namespace ccdfuzz {

/// The exact Taylor expansion of a quadratic patch: for a direction d with Σ d = 0,
/// S(x + s·d) = S(x) + s·slope(x, d) + s²·bend(d, d).

/// Σ d_a e_b c_ab: the patch's bilinear form.
inline Vec3<Dyadic> bend(const Points<Dyadic>& points, const Barycentric& d, const Barycentric& e) {
  Vec3<Dyadic> sum = {Dyadic(), Dyadic(), Dyadic()};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const Dyadic weight = d[a] * e[b];
      if (weight.sign() != 0) sum += points[control_of(a, b)] * weight;
    }
  }
  return sum;
}

inline Vec3<Dyadic> slope(const Points<Dyadic>& points, const Barycentric& x,
                          const Barycentric& d) {
  return bend(points, x, d) * Dyadic(2);
}

inline Barycentric corner_point(int a) {
  Barycentric x;
  x[static_cast<size_t>(a)] = Dyadic(1);
  return x;
}

/// The direction from x to y.
inline Barycentric towards(const Barycentric& x, const Barycentric& y) {
  return {y[0] - x[0], y[1] - x[1], y[2] - x[2]};
}

/// The corner where coordinate a is the only one that is not 0, or the edge where it is the only
/// one that is 0. Requires that x is on a corner or an edge, as the caller says.
inline int corner_of(const Barycentric& x) {
  return x[0].sign() != 0 ? 0 : x[1].sign() != 0 ? 1 : 2;
}
inline int corner_opposite(const Barycentric& x) {
  return x[0].sign() == 0 ? 0 : x[1].sign() == 0 ? 1 : 2;
}

}  // namespace ccdfuzz
