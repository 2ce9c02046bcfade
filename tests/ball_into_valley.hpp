#pragma once

#include "case/query.hpp"

namespace ccdfuzz {

/// A ball of radius 1 falls at speed 1 into a valley between two triangles, y = 3|x|/4, that share
/// the edge x = y = 0. Their fronts look up. It starts above the first, and touches that at t = 1.
inline Query ball_into_valley() {
  Query query;
  auto& [mesh, ball] = query.patches;
  mesh = {Shape::hull(4), {{0, 0, -8}, {0, 0, 8}, {4, 3, 0}, {-4, 3, 0}}, {{0, 0, 0}}};
  mesh.faces = {{0, 1, 2}, {1, 0, 3}};
  ball = {Shape::hull(1), {{2, 3.75, 0}}, {{0, -1, 0}}};
  ball.radius = 1;
  query.t_max = 4;
  return query;
}

}  // namespace ccdfuzz
