#include "fuzz/mutator/aimed_moves.hpp"

#include <cmath>

namespace ccdfuzz {

namespace {

using Field = Points<double> MovingPatch<double>::*;

MovingPatch<double>& any_patch(WitnessedQuery& q, Random& random) {
  return q.query.patches[random.below(2)];
}

Field any_field(Random& random) {
  return random.coin() ? &MovingPatch<double>::positions : &MovingPatch<double>::velocities;
}

Vec3<double>& any_point(Points<double>& points, Random& random) {
  return points[random.below(points.size())];
}

int any_axis(Random& random) {
  return static_cast<int>(random.below(3));
}

/// x by up to four floats up or down.
double beside(double x, Random& random) {
  const double end = random.coin() ? HUGE_VAL : -HUGE_VAL;
  for (std::uint64_t steps = random.below(5); steps > 0; --steps) x = std::nextafter(x, end);
  return x;
}

/// x in multiples of 2^unit.
double on_lattice(double x, int unit) {
  return std::ldexp(std::nearbyint(std::ldexp(x, -unit)), unit);
}

bool is_finite(const Query& query) {
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Field field : {&MovingPatch<double>::positions, &MovingPatch<double>::velocities}) {
      for (const Vec3<double>& p : patch.*field) {
        if (!p.allFinite()) return false;
      }
    }
  }
  return true;
}

bool made_whole(WitnessedQuery& q, Random& random) {
  return is_finite(q.query) && repair(q, random);
}

}  // namespace

bool nudge(WitnessedQuery& q, Random& random) {
  for (std::uint64_t left = 1 + random.below(3); left > 0; --left) {
    MovingPatch<double>& patch = any_patch(q, random);
    Vec3<double>& p = any_point(patch.*any_field(random), random);
    const int k = any_axis(random);
    p[k] = beside(p[k], random);
  }
  return made_whole(q, random);
}

bool make_twins(WitnessedQuery& q, Random& random) {
  const Field field = any_field(random);
  const Vec3<double> model = any_point(any_patch(q, random).*field, random);
  Vec3<double>& p = any_point(any_patch(q, random).*field, random);
  const bool one_axis_only = random.coin();
  const int axis = any_axis(random);
  for (int k = 0; k < 3; ++k) {
    if (!one_axis_only || k == axis) p[k] = beside(model[k], random);
  }
  return made_whole(q, random);
}

bool align_edge(WitnessedQuery& q, Random& random) {
  MovingPatch<double>& patch = any_patch(q, random);
  const size_t i = random.below(patch.positions.size()), j = random.below(patch.positions.size());
  const int axis = any_axis(random);
  if (i == j) return false;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    patch.positions[i][k] = patch.positions[j][k];
    patch.velocities[i][k] = patch.velocities[j][k];
  }
  return made_whole(q, random);
}

bool flatten(WitnessedQuery& q, Random& random) {
  Points<double>& points = any_patch(q, random).*any_field(random);
  const int k = any_axis(random);
  const double level = any_point(points, random)[k];
  for (Vec3<double>& p : points) p[k] = level;
  return made_whole(q, random);
}

bool collapse(WitnessedQuery& q, Random& random) {
  MovingPatch<double>& patch = any_patch(q, random);
  const size_t to = random.below(patch.positions.size());
  const size_t first = random.below(patch.positions.size());
  const size_t count = 1 + random.below(3);
  for (size_t i = first; i < std::min(first + count, patch.positions.size()); ++i) {
    patch.positions[i] = patch.positions[to];
    patch.velocities[i] = patch.velocities[to];
  }
  return made_whole(q, random);
}

bool snap_to_lattice(WitnessedQuery& q, Random& random) {
  Points<double>& points = any_patch(q, random).*any_field(random);
  const double size = any_point(points, random).cwiseAbs().maxCoeff();
  if (size == 0) return false;
  const int unit = std::ilogb(size) - static_cast<int>(random.below(20));
  if (random.coin()) {
    for (Vec3<double>& p : points) {
      for (int k = 0; k < 3; ++k) p[k] = on_lattice(p[k], unit);
    }
  } else {
    Vec3<double>& p = any_point(points, random);
    for (int k = 0; k < 3; ++k) p[k] = on_lattice(p[k], unit);
  }
  return made_whole(q, random);
}

bool stop_motion(WitnessedQuery& q, Random& random) {
  const size_t s = random.below(2);
  const Vec3<double> velocity =
      random.coin() ? any_point(q.query.patches[s].velocities, random) : Vec3<double>(0, 0, 0);
  const bool both = random.coin();
  for (size_t side = 0; side < 2; ++side) {
    if (side != s && !both) continue;
    for (Vec3<double>& v : q.query.patches[side].velocities) v = velocity;
  }
  return made_whole(q, random);
}

bool stretch(WitnessedQuery& q, Random& random) {
  Vec3<double>& p = any_point(any_patch(q, random).*any_field(random), random);
  const int exponent = static_cast<int>(random.between(-40, 20));
  const bool one_axis_only = random.coin();
  const int axis = any_axis(random);
  for (int k = 0; k < 3; ++k) {
    if (!one_axis_only || k == axis) p[k] = std::ldexp(p[k], exponent);
  }
  return made_whole(q, random);
}

}  // namespace ccdfuzz
