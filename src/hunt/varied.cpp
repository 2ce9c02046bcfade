#include "hunt/varied.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/nearest_float.hpp"
#include "case/judge.hpp"
#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_linear.hpp"
#include "method/setting.hpp"

namespace ccdfuzz {

namespace {

/// x rounded down to 12 bits: a float, that is, and nearer to x than by 2^-11 of it.
double rounded_down(double x) {
  constexpr int kBits = 12;
  int exponent = 0;
  const double part = std::frexp(x, &exponent);
  return std::ldexp(std::floor(std::ldexp(part, kBits)), exponent - kBits);
}

/// The same motion from 0 to t_max / until, by the positions at 0 and at 1, asked up to `until`.
Query by_ends(const Query& query, double until, const HuntGround& ground) {
  Query out = query;
  const double step = query.t_max / until;
  for (MovingPatch<double>& patch : out.patches) {
    for (Vec3<double>& v : patch.velocities) v *= step;
    give_rounded_ends(patch);
    for (Vec3<double>& end : patch.ends) {
      for (double& x : end) x = ground.fitted(x);
    }
  }
  out.t_max = until;
  return out;
}

/// The query in units of time in which its speeds are well within the scale, with its numbers
/// rounded as the ground has them.
void fit(Query& query, const HuntGround& ground) {
  double fastest = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    fastest = std::max(fastest, largest_coordinate(patch.velocities));
  }
  const int faster = ground.scale && fastest > 0 ? -2 - std::ilogb(fastest) : 0;
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& v : patch.velocities) v *= std::ldexp(1, faster);
    for_each_coordinate(patch, [&](double& x) { x = ground.fitted(x); });
  }
  query.t_max = ground.fitted(std::ldexp(query.t_max, -faster));
}

/// The query in units of which the claim is about a hundredth of the patches' size.
void bring_to_claim(Query& query, double kept, const HuntGround& ground, Draw& draw) {
  const int claim = std::ilogb(kept);
  // What comes nearer than the claim by a part of it is not shallow then (is_shallow).
  const int most = ground.ordinary ? 7 : 12;
  const int least = ground.scale ? std::clamp(3 - *ground.scale - claim, 4, most) : 4;
  double size = 0;
  for (const MovingPatch<double>& patch : query.patches) {
    for (const Vec3<double>& p : patch.positions) {
      size = std::max(size, (p - patch.positions[0]).cwiseAbs().maxCoeff());
    }
  }
  const int wanted = claim + draw.integer(least, most);
  if (size > 0) scale_lengths(query, wanted - std::ilogb(size));
}

/// Both patches in planes that an axis is normal to, which stay that: then nothing but a plane
/// across the axis is between their boxes.
void level(Query& query, int k) {
  for (MovingPatch<double>& patch : query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) p[k] = points->front()[k];
    }
  }
}

/// The query of a case at a separation, from a little before patches are as near as that until just
/// before they touch, or t_max. nullopt if they are never as near, or at once.
std::optional<Query> before_touch(const Case& near, const HuntGround& ground, Draw& draw) {
  Query touching = near.query;
  touching.separation = 0;
  const std::optional<Case> touch = decided_case(touching);
  if (!touch || near.truth.collides != true) return std::nullopt;
  const double first = near.truth.contact_by()->get_d();
  const double last =
      touch->truth.collides == true ? touch->truth.contact_by()->get_d() : near.query.t_max;
  const double way = last - first;
  if (first <= 0 || way <= 0) return std::nullopt;
  const double from = std::max(0.0, first - std::ldexp(way, draw.integer(0, 6)));
  Query out = near.query;
  out.t_max = first + 0.75 * way - from;
  for (MovingPatch<double>& patch : out.patches) {
    for (size_t i = 0; i < patch.positions.size(); ++i) {
      patch.positions[i] += from * patch.velocities[i];
    }
  }
  fit(out, ground);
  return out;
}

/// The case of bodies with a part of a radius as its separation: nothing else changes. nullopt if
/// neither has a radius.
std::optional<Case> of_radius(Case value, Draw& draw) {
  const auto& [a, b] = value.query.patches;
  if (a.radius == 0 && b.radius == 0) return std::nullopt;
  double& radius = value.query.patches[a.radius == 0 || (b.radius > 0 && draw.coin())].radius;
  value.query.separation = draw.coin() ? radius : radius / 2;
  radius -= value.query.separation;
  return check_case(value) ? std::optional(std::move(value)) : std::nullopt;
}

/// The case at a separation. kept: the claim that it is to be just below, or 0.
std::optional<Case> at_separation(const Case& value, const HuntGround& ground, double kept,
                                  Draw& draw) {
  Query apart = value.query;
  const bool are_bodies = is_of_bodies(apart);
  if (are_bodies && kept == 0) {
    if (auto made = of_radius(value, draw)) return made;
  }
  if (has_turns(apart)) return std::nullopt;  // to decide it takes long
  if (kept > 0) bring_to_claim(apart, kept, ground, draw);
  if (!are_bodies && draw.below(3) == 0) level(apart, draw.integer(0, 2));
  if (kept > 0) {
    if (!are_bodies) fit(apart, ground);
    apart.separation = rounded_down(kept * (1 - 0x1p-10));
  } else {
    const double largest = largest_coordinate(apart);
    if (largest == 0) return std::nullopt;
    const int size = std::ilogb(largest) - draw.integer(5, 12);
    apart.separation = std::ldexp(4 + draw.integer(0, 3), size);
  }
  std::optional<Case> made = decided_case(apart);
  // Until they touch, patches are in contact by the separation alone.
  if (made && !are_bodies && draw.below(4) > 0) {
    if (const auto begun = before_touch(*made, ground, draw)) made = decided_case(*begun);
  }
  return made;
}

/// The case of linear patches, of which one is up to 16 times as fast against the other, from as
/// much farther away. Soon after the contact they are deep in each other. It is decided anew.
std::optional<Case> faster(const Case& value, const HuntGround& ground, Draw& draw) {
  const auto contact = value.truth.contact_by();
  if (has_ends(value.query) || !contact) return std::nullopt;
  Query query = value.query;
  Vec3<double> way(0, 0, 0);
  for (const size_t s : {size_t{0}, size_t{1}}) {
    const Points<double>& velocities = query.patches[s].velocities;
    const double share = (s == 0 ? 1.0 : -1.0) / static_cast<double>(velocities.size());
    for (const Vec3<double>& v : velocities) way += share * v;
  }
  way *= std::ldexp(1.0, draw.integer(1, 4)) - 1;
  MovingPatch<double>& patch = query.patches[0];
  for (Vec3<double>& v : patch.velocities) v += way;
  for (Vec3<double>& p : patch.positions) p -= contact->get_d() * way;
  query.t_max *= 2;  // what rounding makes later
  fit(query, ground);
  std::optional<Case> made = decided_case(query);
  if (made) made->origin = value.origin;
  return made;
}

/// The same case by the positions at 0 and at 1. nullopt if these are no doubles, or the motion
/// ends at 1 before the truth does.
std::optional<Case> by_exact_ends(Case value) {
  const Query by_velocities = value.query;
  for (MovingPatch<double>& patch : value.query.patches) give_rounded_ends(patch);
  const bool is_same = with_velocities(value.query) == by_velocities;
  return is_same && check_case(value) ? std::optional(std::move(value)) : std::nullopt;
}

}  // namespace

std::optional<Case> varied(const Case& value, const HuntGround& ground, const Features& features,
                           Draw& draw) {
  const Query& query = value.query;
  const bool are_bodies = is_of_bodies(query);
  const bool is_plain = (are_bodies || (is_linear_query(query) && !has_ends(query) &&
                                        !is_trimmed(query) && query.t_max > 0)) &&
                        query.separation == 0;
  if (ground.uniform) return std::nullopt;
  // Elsewhere families of generators have ends enough.
  const bool is_limited = ground.binary32 || ground.scale || ground.ordinary || are_bodies;
  if (!is_plain) {
    const bool has_velocities = !has_ends(query) && !are_bodies;
    if (!has_velocities || !features.ends || !is_limited || draw.coin()) return std::nullopt;
    const std::optional<Case> of_ends = by_exact_ends(value);
    return of_ends && ground.has(*of_ends) ? of_ends : std::nullopt;
  }
  const double kept = features.kept_separation;
  const bool is_apart = kept > 0 ? draw.coin() : features.separation && draw.below(6) == 0;
  // What is asked as it is comes up to four times (forms_of).
  const bool is_of_ends = features.ends && is_limited && !are_bodies &&
                          draw.below(8) < (ground.binary32 ? std::uint64_t{7} : std::uint64_t{4});
  std::optional<Case> made;
  if (is_apart) made = at_separation(value, ground, kept, draw);
  if (made && !ground.has(*made)) made.reset();
  constexpr int kTries = 3;
  for (int left = is_of_ends ? kTries : 0; left > 0; --left) {
    Query moving = made ? made->query : query;
    // A contact that is planted comes at t_max, or well before that.
    if (!made) moving.t_max *= draw.pick(std::array{1.0, 1.5, 2.0, 2.0});
    const double until = made || draw.below(4) > 0 ? 1 : 0.5;
    std::optional<Case> of_ends = decided_case(by_ends(moving, until, ground));
    if (!of_ends || !ground.has(*of_ends)) continue;
    made = std::move(of_ends);
    break;
  }
  if (made) {
    made->origin.generator = value.origin.generator;
    made->origin.seed = value.origin.seed;
    made->origin.index = value.origin.index;
  }
  return made;
}

std::optional<Case> near_an_end(const Case& value, const HuntGround& ground, Draw& draw) {
  const int most = ground.ordinary ? -std::ilogb(kEndShare) : 20;
  const int k = draw.coin() ? most : draw.integer(ground.ordinary ? 1 : 0, most);
  // A little more than the share, of few bits, which is well inside of an ordinary step.
  const double last = 1 + std::ldexp(1 + 0x1p-9, -k), first = std::ldexp(1 - 0x1p-9, k);
  const bool is_last = draw.coin();
  const bool may_be_shallow = ground.ordinary && is_last && is_linear_query(value.query);
  const std::optional<Case> known = may_be_shallow ? faster(value, ground, draw) : value;
  const auto contact = known ? known->truth.contact_by() : std::nullopt;
  if (!contact || *contact == 0) return std::nullopt;
  double t_max = round_up(*contact * exact(k == 0 ? 1 : is_last ? last : first));
  if (ground.binary32) t_max = nearest_float(t_max);
  if (!std::isfinite(t_max) || is_past_motion(known->query, t_max)) return std::nullopt;
  Case made = ground.fitted(with_t_max(*known, t_max));
  return made.truth.collides == true && ground.has(made) ? std::optional(made) : std::nullopt;
}

}  // namespace ccdfuzz
