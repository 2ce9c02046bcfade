#include "certify/oracle/turned_points.hpp"

#include "certify/oracle/rational_roots.hpp"

namespace ccdfuzz {

namespace {

Vec3<Rational> cross_of(const Vec3<Rational>& a, const Vec3<Rational>& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

/// The quaternion of a rotation by a small part of the angle, multiplied with itself.
std::vector<Rational> quaternion_at(const std::vector<double>& spin, const Rational& t) {
  // Six terms of an angle below 2^-13 are off by less than 2^-160. Each squaring doubles an error.
  constexpr int kSquarings = 16;
  constexpr long kBits = 160;
  const auto rounded = [](const Rational& x) { return rounded_down(x, power_of_two(-kBits)); };
  Vec3<Rational> u;
  Rational x = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = rounded(exact(spin[static_cast<size_t>(k)]) * t * power_of_two(-kSquarings - 1));
    x += u[k] * u[k];
  }
  Rational w = 1, sine = 1, term = 1;
  for (int n = 1; n <= 5; ++n) {
    term = rounded(-term * x / (2 * n * (2 * n - 1)));
    w += term;
    sine += rounded(term / (2 * n + 1));
  }
  for (int k = 0; k < 3; ++k) u[k] *= sine;
  for (int i = 0; i < kSquarings; ++i) {
    // (w + u)² = w² − u·u + 2w u
    const Rational square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    for (int k = 0; k < 3; ++k) u[k] = rounded(2 * w * u[k]);
    w = rounded(w * w - square);
  }
  return {w, u[0], u[1], u[2]};
}

}  // namespace

PointsAt points_at(const MovingPatch<double>& body, const Rational& t) {
  PointsAt out;
  std::vector<Rational> q;
  Rational squared = 0, root = 1;
  Vec3<Rational> centre{0, 0, 0};
  if (body.turn) {
    const BodyTurn& turn = *body.turn;
    if (turn.is_spin()) q = quaternion_at(turn.spin, t);
    for (size_t i = 0; i < turn.from.size(); ++i) {
      q.push_back((1 - t) * exact(turn.from[i]) + t * exact(turn.to[i]));
    }
    for (const Rational& x : q) squared += x * x;
    if (turn.is_spin()) squared = 1;  // but for less than 2^-140
    centre = exact(turn.centre);
    out.are_exact = !turn.is_spin();
    if (q.size() == 2) {
      root = root_above(squared);
      out.are_exact = root * root == squared;
    }
  }
  const Vec3<Rational> velocity = exact(body.velocities[0]);
  for (const Vec3<double>& position : body.positions) {
    Vec3<Rational> p = exact(position);
    for (int k = 0; k < 3; ++k) p[k] -= centre[k];
    if (q.size() == 2) {
      p = {Rational((q[0] * p[0] - q[1] * p[1]) / root),
           Rational((q[1] * p[0] + q[0] * p[1]) / root), p[2]};
    } else if (q.size() == 4) {
      // p + 2w (u × p) + 2 u × (u × p), over |q|²
      const Vec3<Rational> u{q[1], q[2], q[3]}, once = cross_of(u, p), twice = cross_of(u, once);
      for (int k = 0; k < 3; ++k) p[k] += 2 * (q[0] * once[k] + twice[k]) / squared;
    }
    for (int k = 0; k < 3; ++k) p[k] += centre[k] + t * velocity[k];
    out.points.push_back(std::move(p));
  }
  return out;
}

}  // namespace ccdfuzz
