// Convex bodies as Bullet has them: about the point that they turn about, with their radius as the
// margin.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include "../../plugins/adapter.hpp"

inline btVector3 vector(const double (&x)[3]) {
  return {adapter::as_float(x[0]), adapter::as_float(x[1]), adapter::as_float(x[2])};
}

inline btVector3 nearest(const double (&x)[3]) {
  return {static_cast<btScalar>(x[0]), static_cast<btScalar>(x[1]), static_cast<btScalar>(x[2])};
}

/// What a body turns about. One that does not, and is farther from the origin than 128, is about
/// its first point, as bodies of a large world are.
inline btVector3 middle(const ccdfuzz_patch& body) {
  if (body.turn_count > 0) return vector(body.turn_centre);
  const btVector3 first = vector(body.positions[0]);
  return first.absolute()[first.absolute().maxAxis()] > 128 ? first : btVector3(0, 0, 0);
}

/// What rounding adds where bodies spin: 1e-4 of turns, up to 443 from a centre. Points about it
/// are up to 256 along each of three axes, where a float is rounded by 2^-17; there are two bodies.
const double spin_rounding = 1e-4 + 2 * std::sqrt(3) * 0x1p-17;
/// And far off: two positions and a way, along three axes.
const double far_rounding = 3 * std::sqrt(3) * 0x1p-8;

inline btConvexHullShape hull(const ccdfuzz_patch& body) {
  btConvexHullShape shape;
  for (std::uint64_t i = 0; i < body.count; ++i) {
    double about[3];
    for (int k = 0; k < 3; ++k) {
      about[k] = body.positions[i][k] - double{middle(body)[k]};
      if (std::abs(about[k]) > 256) throw adapter::Refusal("a body far off is wide");
    }
    // Differences of floats of few bits are floats; about a spin's centre they are rounded.
    shape.addPoint(body.turn_count > 0 ? nearest(about) : vector(about), false);
  }
  shape.recalcLocalAabb();
  shape.setMargin(adapter::as_float(body.radius));
  return shape;
}

/// Where a body is at time t. It may turn by π/4 until then.
inline btTransform place(const ccdfuzz_patch& body, double t) {
  const auto [w, x, y, z] = adapter::spun(body, t, SIMD_PI / 4);
  double way[3];
  for (int k = 0; k < 3; ++k) way[k] = t * body.velocities[0][k];
  const btQuaternion turn(static_cast<btScalar>(x), static_cast<btScalar>(y),
                          static_cast<btScalar>(z), static_cast<btScalar>(w));
  return btTransform(turn, middle(body) + vector(way));  // rounded, as the tolerance allows
}
