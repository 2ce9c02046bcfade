#include "generators/round.hpp"

#include <cmath>

#include "base/verify.hpp"
#include "certify/checker/check_truth.hpp"
#include "generators/attempts.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"
#include "generators/whole_frame.hpp"

namespace ccdfuzz {

Profile circular_profile(std::int64_t ring, std::int64_t radius, Draw& draw) {
  const QuarterCircle& quarter = draw.pick(kQuarterCircles);
  Profile out{{}, {}, ring + QuarterCircle::kRadius * radius, Rational(1, quarter.at)};
  out.ring = ring;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto& [x, y] = quarter.points[j];
    out.points.push_back({ring + radius * x, radius * y});
    out.weights.push_back(QuarterCircle::kWeights[j]);
  }
  return out;
}

Profile straight_profile(bool slants, Draw& draw) {
  const std::int64_t distance = 15 * draw.integer(1, 3);
  // A cone may end in its tip.
  const std::int64_t below = draw.integer(1, 5), above = draw.integer(1, 5);
  const std::int64_t way = slants ? 3 : 0;
  Profile out{{{distance - way * below, -4 * below}, {distance + way * above, 4 * above}},
              {1, 1},
              distance,
              Rational(static_cast<long>(below)) / static_cast<long>(below + above)};
  out.slants = slants;
  return out;
}

RoundSide revolve(const Profile& profile, const QuarterCircle& quarter) {
  RoundSide out;
  out.shape = Shape::tensor(2, static_cast<int>(profile.points.size()) - 1);
  out.at = {Rational(1, quarter.at), profile.at};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [c, s] = quarter.points[i];
    for (std::size_t j = 0; j < profile.points.size(); ++j) {
      const auto& [distance, height] = profile.points[j];
      const std::int64_t r = QuarterCircle::kRadius;
      const std::int64_t x = distance * s, y = r * height, z = distance * c - r * profile.distance;
      out.points.push_back(profile.slants ? Whole{5 * x, 4 * y + 3 * z, 4 * z - 3 * y}
                                          : 5 * Whole{x, y, z});
      out.weights.push_back(QuarterCircle::kWeights[i] * profile.weights[j]);
    }
  }
  return out;
}

namespace {

/// The radius of a circle of radius 1 in a scene, 125 times kRadius.
constexpr std::int64_t kLength = 625;

Profile draw_profile(Draw& draw) {
  switch (draw.below(4)) {
    case 0:
      return circular_profile(0, draw.integer(1, 6), draw);
    case 1: {
      const std::int64_t radius = draw.integer(1, 4);
      return circular_profile(QuarterCircle::kRadius * draw.integer(1, 4), radius, draw);
    }
    case 2:
      return straight_profile(false, draw);
    default:
      return straight_profile(true, draw);
  }
}

RoundSide draw_revolved(Draw& draw) {
  const auto& turn = draw.pick(kQuarterCircles);
  return revolve(draw_profile(draw), turn);
}

/// What touches the plane z = 0 from above. Its lengths are 125 times those of profiles.
RoundSide draw_other(ContactClass contact, Draw& draw) {
  if (contact == ContactClass::kVF) return {Shape::point(), {Whole{}}, {}, {0, 0}};
  if (draw.coin()) {
    const std::int64_t size = kLength * draw.integer(1, 8);
    return {Shape::triangle(1),
            {size * Whole{-3, -1, 0}, size * Whole{3, -1, 0}, size * Whole{0, 2, 0}},
            {},
            {Rational(1, 3), Rational(1, 3)}};
  }
  RoundSide out = draw_revolved(draw);
  constexpr std::array<std::array<std::int64_t, 2>, 3> kTurns = {{{5, 0}, {0, 5}, {3, 4}}};
  const auto& [c, s] = draw.pick(kTurns);
  // Five times as large, with its axis in another direction.
  for (Whole& p : out.points) p = {c * p[0] - s * p[1], s * p[0] + c * p[1], -5 * p[2]};
  return out;
}

}  // namespace

Case draw_round_case(ContactClass contact, bool apart, Draw& draw) {
  std::array<RoundSide, 2> sides = {draw_revolved(draw), draw_other(contact, draw)};
  for (Whole& p : sides[0].points) p = 5 * p;
  const WholeFrame frame = draw_right_angles(draw);
  const std::int64_t gap = apart ? kLength * draw.integer(1, 8) : 0;
  const std::int64_t eighths = draw.integer(1, 8);
  // A length of up to 10 in a unit of time, and mostly towards each other.
  Whole approach = kLength * any_whole(draw, 4);
  approach[2] = kLength * draw.integer(2, 10);
  const Whole common = draw.coin() ? Whole{} : kLength * any_whole(draw, 4);
  const Whole place = draw.coin() ? Whole{} : kLength * any_whole(draw, 16);
  const std::uint64_t mover = draw.below(2);
  const int unit = draw.integer(-16, 0);

  Case out;
  Witness witness;
  witness.t = Rational(static_cast<long>(eighths)) / 8;
  out.query.t_max = static_cast<double>(eighths * draw.integer(4, 8)) / 32;
  for (std::size_t s = 0; s < 2; ++s) {
    const Whole velocity = frame(s != mover ? common
                                 : s == 0   ? common + approach
                                            : common + -1 * approach);
    MovingPatch<double>& patch = out.query.patches[s];
    patch.shape = sides[s].shape;
    patch.weights = sides[s].weights;
    for (Whole p : sides[s].points) {
      if (s == 1) p[2] += gap;
      patch.positions.push_back(times_power(8 * frame(p + place) + -eighths * velocity, unit - 3));
      patch.velocities.push_back(times_power(velocity, unit));
    }
    witness.uv[s] = sides[s].at;
  }
  out.query.separation = std::ldexp(static_cast<double>(gap * frame.length), unit);
  Truth& truth = out.truth;
  truth.collides = true;
  truth.witness = witness;
  MovingPlane plane{witness.t, {}, 0};
  const Whole normal = -1 * frame.axes[2];
  for (std::size_t k = 0; k < 3; ++k) plane.normal[k] = static_cast<long>(normal[k]);
  const Whole at_second = frame(place + Whole{0, 0, gap});
  plane.offset = static_cast<long>(dot(normal, at_second)) * power_of_two(unit);
  CCDFUZZ_VERIFY(check_clearance(out.query, plane));
  truth.clearance = plane;
  truth.clear_until = plane.until;
  CCDFUZZ_VERIFY(check_truth(out));
  return out;
}

/// As draw_round_case makes them, of the families round and apart.
Attempted round_case(const GeneratorOptions& options, Draw& draw) {
  const bool apart = options.family == Family::kApart;
  return as_asked(draw_round_case(options.contact, apart, draw), options);
}

}  // namespace ccdfuzz
