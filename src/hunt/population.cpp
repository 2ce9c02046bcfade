#include "hunt/population.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bezier/bernstein.hpp"

namespace ccdfuzz {

namespace {

Niche niche_at(Niche::By by, const TracePlace& place, int axis) {
  return {by, static_cast<std::int16_t>(place.level), static_cast<std::int16_t>(axis)};
}

/// Within an ulp; for guides alone.
double about(const Dyadic& x) {
  return x.rational().get_d();
}

/// What an axis makes of both patches at a time. It is how fast they close in the contact, and the
/// largest number that their heights are computed from.
struct OnAxis {
  double closing = 0, magnitude = 0;

  OnAxis(const Contact& q, const Vec3<double>& axis, double t) {
    for (size_t s = 0; s < 2; ++s) {
      const MovingPatch<double>& patch = q.query.patches[s];
      const auto weights =
          bernstein_weights<double>(patch.shape, {about(q.uv[s][0]), about(q.uv[s][1])});
      for (size_t i = 0; i < weights.size(); ++i) {
        const Vec3<double> velocity = rounded_velocity(patch, i);
        const double speed = axis.dot(velocity);
        closing += (s == 0 ? 1 : -1) * weights[i] * speed;
        magnitude = std::max(magnitude, axis.cwiseAbs().dot(patch.positions[i].cwiseAbs() +
                                                            t * velocity.cwiseAbs()));
      }
    }
  }
};

double nearness(const Contact& q, const ExcludedInterval& by) {
  constexpr double kRounding = 0x1p-53;
  const double t = about(q.t);
  const double apart = std::max({0.0, by.times.lo - t, t - by.times.hi});
  if (apart == 0) return 0;
  const OnAxis on(q, by.direction, t);
  const double near = std::abs(on.closing) / on.magnitude * (apart / kRounding);
  // Where nothing closes, nothing is near for that.
  return near > 0 ? near : std::numeric_limits<double>::infinity();
}

}  // namespace

Standing standing_of(const Contact& q, const Trace& trace) {
  if (trace.slack) {
    return {niche_at(Niche::By::kGap, trace.slack->place, trace.slack->gap.axis),
            trace.slack->value};
  }
  if (trace.margin) {
    const ExcludedInterval& by = trace.margin->by;
    const bool at_start = by.times.lo <= trace.margin->place.window.lo;
    return {niche_at(at_start ? Niche::By::kExcludedStart : Niche::By::kExcludedRest,
                     trace.margin->place, by.axis),
            nearness(q, by)};
  }
  return {{}, std::numeric_limits<double>::infinity()};
}

void Population::join(Contact q, const Standing& standing) {
  const auto [at, is_new] = places_.try_emplace(standing.niche, members_.size());
  if (is_new) {
    members_.push_back({std::move(q), standing.nearness});
  } else if (Member& old = members_[at->second]; standing.nearness <= old.nearness) {
    old = {std::move(q), standing.nearness};
  }
}

const Contact& Population::nearer_of_two(Draw& draw) const {
  const Member& a = members_[draw.below(members_.size())];
  const Member& b = members_[draw.below(members_.size())];
  return a.nearness <= b.nearness ? a.q : b.q;
}

}  // namespace ccdfuzz
