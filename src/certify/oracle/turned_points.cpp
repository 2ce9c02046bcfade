#include "certify/oracle/turned_points.hpp"

#include "certify/oracle/rational_roots.hpp"

namespace ccdfuzz {

namespace {

Vec3<Rational> cross_of(const Vec3<Rational>& a, const Vec3<Rational>& b) {
  return {Rational(a[1] * b[2] - a[2] * b[1]), Rational(a[2] * b[0] - a[0] * b[2]),
          Rational(a[0] * b[1] - a[1] * b[0])};
}

}  // namespace

PointsAt points_at(const MovingPatch<double>& body, const Rational& t) {
  PointsAt out;
  std::vector<Rational> q;
  Rational squared = 0, root = 1;
  Vec3<Rational> centre{0, 0, 0};
  if (body.turn) {
    const BodyTurn& turn = *body.turn;
    for (size_t i = 0; i < turn.from.size(); ++i) {
      q.push_back((1 - t) * exact(turn.from[i]) + t * exact(turn.to[i]));
      squared += q[i] * q[i];
    }
    centre = exact(turn.centre);
    if (!turn.is_quaternion()) {
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
