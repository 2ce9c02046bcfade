#include "certify/oracle/turned_points.hpp"

#include "certify/oracle/rational_roots.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// The quaternion of a rotation by a small part of the angle, multiplied with itself.
std::vector<Fraction> quaternion_at(const std::vector<double>& spin, const Fraction& t) {
  // Six terms of an angle below 2^-13 are off by less than 2^-160. Each squaring doubles an error.
  constexpr int kSquarings = 16;
  constexpr long kBits = 160;
  const Dyadic unit(1, -kBits);
  const auto rounded = [&](const Fraction& x, int divisor = 1) -> Fraction {
    return Dyadic(floor_of_ratio(x, divisor * unit), -kBits);
  };
  const Fraction part = t * Dyadic(1, -kSquarings - 1);
  Vec3<Fraction> u;
  Fraction x = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = rounded(from_double<Fraction>(spin[static_cast<size_t>(k)]) * part);
    x += u[k] * u[k];
  }
  Fraction w = 1, sine = 1, term = 1;
  for (int n = 1; n <= 5; ++n) {
    term = rounded(-term * x, 2 * n * (2 * n - 1));
    w += term;
    sine += rounded(term, 2 * n + 1);
  }
  for (int k = 0; k < 3; ++k) u[k] = u[k] * sine;
  for (int i = 0; i < kSquarings; ++i) {
    // (w + u)² = w² − u·u + 2w u
    const Fraction square = dot(u, u);
    for (int k = 0; k < 3; ++k) u[k] = rounded(2 * w * u[k]);
    w = rounded(w * w - square);
  }
  return {w, u[0], u[1], u[2]};
}

}  // namespace

Points<Rational> PointsAt::rational() const {
  Points<Rational> out;
  for (const Vec3<Fraction>& p : dividends) {
    const auto x = [&](int k) { return (p[k] / divisor).rational(); };
    out.emplace_back(x(0), x(1), x(2));
  }
  return out;
}

Points<Integer> PointsAt::in_units(const Fraction& unit) const {
  const Fraction by = divisor * unit;
  Points<Integer> out;
  for (const Vec3<Fraction>& p : dividends) {
    const auto x = [&](int k) { return floor_of_ratio(p[k], by); };
    out.emplace_back(x(0), x(1), x(2));
  }
  return out;
}

PointsAt points_at(const MovingPatch<double>& body, const Rational& time) {
  const Fraction t = time;
  PointsAt out;
  std::vector<Fraction> q;
  Vec3<double> centre{0, 0, 0};
  if (body.turn) {
    const BodyTurn& turn = *body.turn;
    centre = turn.centre;
    out.are_exact = !turn.is_spin();
    if (turn.is_spin()) q = quaternion_at(turn.spin, t);  // of length 1 but for less than 2^-140
    for (size_t i = 0; i < turn.from.size(); ++i) {
      q.push_back((1 - t) * from_double<Fraction>(turn.from[i]) +
                  t * from_double<Fraction>(turn.to[i]));
    }
    Fraction squared = 0;
    for (const Fraction& x : q) squared += x * x;
    if (turn.is_quaternion()) out.divisor = squared;
    if (q.size() == 2) {
      out.divisor = root_above(squared.rational());
      out.are_exact = out.divisor * out.divisor == squared;
    }
  }
  Vec3<Fraction> origin;  // times the divisor, as what follows
  for (int k = 0; k < 3; ++k) {
    const Fraction way = t * from_double<Fraction>(body.velocities[0][k]);
    origin[k] = out.divisor * (from_double<Fraction>(centre[k]) + way);
  }
  for (const Vec3<double>& position : body.positions) {
    Vec3<Fraction> p, at = origin;
    for (int k = 0; k < 3; ++k) {
      p[k] = from_double<Fraction>(position[k]) - from_double<Fraction>(centre[k]);
    }
    if (q.size() == 2) {
      at[0] += q[0] * p[0] - q[1] * p[1];
      at[1] += q[1] * p[0] + q[0] * p[1];
      at[2] += out.divisor * p[2];
    } else {
      for (int k = 0; k < 3; ++k) at[k] += out.divisor * p[k];
    }
    if (q.size() == 4) {
      // p + 2w (u × p) + 2 u × (u × p), over |q|²
      const Vec3<Fraction> u{q[1], q[2], q[3]}, once = cross(u, p), twice = cross(u, once);
      for (int k = 0; k < 3; ++k) at[k] += 2 * (q[0] * once[k] + twice[k]);
    }
    out.dividends.push_back(std::move(at));
  }
  return out;
}

}  // namespace ccdfuzz
