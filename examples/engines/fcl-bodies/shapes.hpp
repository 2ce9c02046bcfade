// Balls and tetrahedra as FCL has them, and how they move.
#pragma once

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/interp_motion.h>

#include "../far.hpp"

using Vector = fcl::Vector3d;
using Motion = fcl::InterpMotion<double>;

/// The origin of a body's own frame. A body that is farther off than 128 is about its first point,
/// as bodies of a large world are.
inline Vector origin(const ccdfuzz_patch& body) {
  const Vector first(body.positions[0]);
  return body.count == 1 || first.cwiseAbs().maxCoeff() > 128 ? first : Vector(0, 0, 0);
}

inline std::unique_ptr<fcl::ShapeBased> shape(const ccdfuzz_patch& body) {
  if (body.count == 1) return std::make_unique<fcl::Sphered>(body.radius);
  auto points = std::make_shared<std::vector<Vector>>();
  for (std::uint64_t i = 0; i < body.count; ++i) {
    const Vector p(body.positions[i]), about = p - origin(body);
    if (about.cwiseAbs().maxCoeff() > 256) throw adapter::Refusal("a body far off is wide");
    if (about + origin(body) != p || p - about != origin(body)) {
      throw adapter::Refusal("a way between two corners is no double");
    }
    points->push_back(about);
  }
  const auto way = [&](int i) -> Vector { return (*points)[i] - (*points)[0]; };
  if (way(1).cross(way(2)).dot(way(3)) < 0) std::swap((*points)[2], (*points)[3]);
  // Each is seen from outside counterclockwise.
  const auto faces = std::make_shared<std::vector<int>>(
      std::vector<int>{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3});
  return std::make_unique<fcl::Convexd>(points, 4, faces);
}

/// About the spin's centre, which is a point of the body's own frame.
inline Motion motion(const ccdfuzz_patch& body, double t_max) {
  Vector centre = origin(body);
  if (body.turn_count > 0) centre = Vector(body.turn_centre);
  const auto [w, x, y, z] = adapter::spun(body, t_max, 3);  // from pi on it turns the other way
  const fcl::Matrix3d turned = fcl::Quaterniond(w, x, y, z).toRotationMatrix();
  const Vector arm = centre - origin(body);
  const Vector end = centre + t_max * Vector(body.velocities[0]) - turned * arm;
  return {fcl::Matrix3d::Identity(), origin(body), turned, end, arm};
}
