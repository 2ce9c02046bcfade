#pragma once

#include <cmath>

#include "case/query.hpp"

namespace ccdfuzz {

/// A point moving from p with velocity v.
inline MovingPatch<double> moving_point(const Vec3<double>& p, const Vec3<double>& v) {
  return {Shape::point(), {p}, {v}};
}

/// The flat triangle (degree 1) with corners (0,0,z), (1,0,z), (0,1,z), moving with velocity v.
inline MovingPatch<double> flat_triangle(double z, const Vec3<double>& v) {
  return {Shape::triangle(1), {{0, 0, z}, {0, 1, z}, {1, 0, z}}, {v, v, v}};
}

/// Every length of the query times 2^k. Requires that nothing rounds.
inline Query scaled(Query query, int k) {
  for (MovingPatch<double>& patch : query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) {
        for (int i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], k);
      }
    }
  }
  return query;
}

}  // namespace ccdfuzz
