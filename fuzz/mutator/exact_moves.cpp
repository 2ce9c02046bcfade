#include "fuzz/mutator/moves.hpp"

#include <cmath>

#include "base/double_parts.hpp"
#include "case/scale.hpp"
#include "fuzz/mutator/repair.hpp"
#include "generators/draw_patch.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

/// The exponent e of the largest coordinate, which is at least 2^(e-1) and less than 2^e; 0 if all
/// are 0.
int exponent_of(const Points<double>& points) {
  return parts_of(largest_coordinate(points)).top();
}

/// A vector of few bits, from as large as the points down to their last bit; often along one axis.
Vec3<Dyadic> small_vector(const Points<double>& points, Draw& draw) {
  constexpr int kBits = 3, kPrecision = 53;
  const long unit = exponent_of(points) - kBits - static_cast<long>(draw.below(kPrecision));
  const bool along_an_axis = draw.coin();
  const std::uint64_t axis = draw.below(3);
  Vec3<Dyadic> v = draw.vector(kBits, unit);
  for (int k = 0; k < 3 && along_an_axis; ++k) {
    if (static_cast<std::uint64_t>(k) != axis) v[k] = Dyadic();
  }
  return v;
}

/// To the contact in other coordinates. False if a number of it is not a double then.
bool change_to_similar(Contact& q, const Similarity& change) {
  const std::optional<Query> changed = similar(q.query, change);
  if (!changed) return false;
  q.query = *changed;
  q.t = q.t.scaled(change.time);
  return true;
}

}  // namespace

bool shift_in_null_space(Contact& q, Draw& draw) {
  const size_t side = draw.below(2);
  MovingPatch<double>& patch = q.query.patches[side];
  Points<double>& points = draw.coin() ? patch.positions : patch.moves();
  const std::vector<Dyadic> weights = q.weights(side);
  const size_t i = draw.below(points.size()), j = draw.below(points.size());
  const Vec3<Dyadic> by = small_vector(points, draw);
  if (weights[i].sign() == 0) return add_exactly(points[i], by);
  if (i == j || weights[j].sign() == 0) return false;
  // Their common power of two serves nothing but to need bits.
  const long unit = std::min(weights[i].exponent(), weights[j].exponent());
  return add_exactly(points[i], by * weights[j].scaled(-unit)) &&
         add_exactly(points[j], by * -weights[i].scaled(-unit));
}

bool trade_position_for_velocity(Contact& q, Draw& draw) {
  MovingPatch<double>& patch = q.query.patches[draw.below(2)];
  if (patch.has_ends()) return false;
  const size_t i = draw.below(patch.positions.size());
  const Vec3<Dyadic> by = small_vector(patch.velocities, draw);
  return add_exactly(patch.velocities[i], by) && add_exactly(patch.positions[i], by * -q.t);
}

bool change_coordinates(Contact& q, Draw& draw) {
  constexpr int kFarthest = 40;  // 2^40 sizes of a patch away; more seldom fits into doubles
  Similarity change;
  const auto far_vector = [&](const Points<double>& points) {
    const int size = exponent_of(points) + draw.integer(-20, kFarthest);
    Vec3<double> v = draw_integers(draw, 3);
    for (double& x : v) x = std::ldexp(x, size);
    return v;
  };
  switch (draw.below(5)) {
    case 0:
      change.shift = far_vector(q.query.patches[0].positions);
      break;
    case 1:
      change.drift = far_vector(q.query.patches[0].moves());
      break;
    case 2:
      change.space = draw.integer(-60, 60);
      break;
    case 3:
      change.time = draw.integer(-30, 30);
      break;
    default:  // towards the ends of the range of doubles
      change.space = draw.integer(-1000, 900);
      break;
  }
  return change_to_similar(q, change);
}

bool splice(Contact& q, const Contact& other, Draw& draw) {
  const size_t to = draw.below(2), from = draw.below(2);
  MovingPatch<double> patch = other.query.patches[from];
  if (patch.has_ends() != q.query.patches[to].has_ends()) return false;
  const Dyadic later = other.t - q.t;
  for (size_t i = 0; i < patch.velocities.size(); ++i) {
    if (!add_exactly(patch.positions[i], exact_dyadic(patch.velocities[i]) * later)) return false;
  }
  q.query.patches[to] = std::move(patch);
  q.uv[to] = other.uv[from];
  return repair(q, draw);
}

bool change_horizon(Contact& q, Draw& draw) {
  const double t = q.t.rational().get_d();  // towards zero
  const double just_enough = Dyadic::exact(t) == q.t ? t : std::nextafter(t, HUGE_VAL);
  constexpr std::array kFactors = {1.0, 1 + 0x1p-30, 1.5, 2.0, 16.0};
  const double t_max =
      draw.coin() ? just_enough * draw.pick(kFactors) : std::nextafter(just_enough, HUGE_VAL);
  if (!std::isfinite(t_max) || is_past_motion(q.query, t_max)) return false;
  q.query.t_max = t_max;
  return true;
}

bool give_separation(Contact& q, Draw& draw) {
  const int size = exponent_of(q.query.patches[0].positions);
  const int exponent = -1 - static_cast<int>(draw.below(20));
  q.query.separation = std::ldexp(std::ldexp(static_cast<double>(draw.below(4)), exponent), size);
  return std::isfinite(q.query.separation);
}

bool give_weights(Contact& q, Draw& draw) {
  const size_t side = draw.below(2);
  MovingPatch<double>& patch = q.query.patches[side];
  const size_t count = patch.positions.size();
  if (count == 1) return false;
  if (draw.coin()) {
    patch.weights = draw_patch_weights(draw, count);
    return repair(q, draw);
  }
  return pull_by_weights(draw, q, side, 3);
}

bool give_ends(Contact& q, Draw& draw) {
  if (q.query.t_max > 1) {
    Similarity change;
    change.time = -(std::ilogb(q.query.t_max) + 1);
    if (!change_to_similar(q, change)) return false;
  }
  const std::uint64_t sides = 1 + draw.below(3);
  bool any = false;
  for (size_t s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = q.query.patches[s];
    if ((sides >> s & 1) == 0 || patch.has_ends()) continue;
    give_rounded_ends(patch);
    any = true;
  }
  return any && is_valid(q.query) && repair(q, draw);
}

}  // namespace ccdfuzz
