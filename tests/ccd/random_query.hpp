#pragma once

#include "bezier/exact_patch.hpp"
#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Two patches of random control points and velocities.
inline Query random_query(const Shape& first, const Shape& second, std::uint64_t key) {
  Draw random{Random::keyed({key})};
  const auto draw_points = [&random](int count) {
    Points<Dyadic> points;
    for (int i = 0; i < count; ++i) points.push_back(random.vector(10, -8));
    return to_doubles(points).value();
  };
  Query query;
  query.t_max = 1;
  query.patches[0].shape = first;
  query.patches[1].shape = second;
  for (MovingPatch<double>& patch : query.patches) {
    patch.positions = draw_points(patch.shape.control_count());
    patch.velocities = draw_points(patch.shape.control_count());
  }
  return query;
}

/// The same patch twice, at rest: every pair of parts that touch does so at all times.
inline Query twice_the_same(const Shape& shape) {
  Query query = random_query(shape, shape, 12);
  query.patches[0].velocities.assign(query.patches[0].velocities.size(), {0, 0, 0});
  query.patches[1] = query.patches[0];
  return query;
}

}  // namespace ccdfuzz
