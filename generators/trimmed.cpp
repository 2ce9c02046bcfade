#include <algorithm>
#include <cmath>

#include "bezier/trim.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/oracle.hpp"
#include "generators/draw_patch.hpp"
#include "generators/draw_trim.hpp"
#include "generators/finalize.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/shaped_case.hpp"
#include "generators/weighted.hpp"

namespace ccdfuzz {

namespace {

using Loop = std::vector<Uv<double>>;

/// Where a region has the contact of the whole patches; only of the last two it has not.
enum class Place : std::uint8_t {
  kInside,
  kOnEdge,
  kOnVertex,
  kFloatInside,
  kInSliver,
  kAtTouchingLoops,
  kOnIsland,
  kFloatOutside,
  kInHole,
};
constexpr std::array kPlacesOfContacts = {
    Place::kInside,   Place::kOnEdge,          Place::kOnVertex, Place::kFloatInside,
    Place::kInSliver, Place::kAtTouchingLoops, Place::kOnIsland};

/// A loop with p on an edge, or as a vertex, whose edge there has both ends moved by up to a float.
Loop draw_loop_beside(Draw& draw, const Shape& shape, const Uv<double>& p) {
  Loop loop = draw_loop_through(draw, shape, p, draw.coin());
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    for (double& x : loop[i]) x = draw.nudged(x, 1);
  }
  return loop;
}

/// A triangle that is a few floats high; or what is left of one that another is cut out of.
Trim draw_sliver(Draw& draw, const Shape& shape, const Uv<double>& p) {
  Loop loop = draw_loop_through(draw, shape, p, false);
  if (draw.coin()) {
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) loop[2][k] = draw.nudged(p[k], 4);
    return {loop};
  }
  Loop inner = loop;
  const double share = std::ldexp(1, -draw.integer(2, 40));
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    inner[2][k] += share * (p[k] - inner[2][k]);
  }
  return {loop, inner};
}

/// Loops that may have p at that place. The third vertex of the last one has few bits, but in a
/// sliver.
Trim draw_loops(Place place, Draw& draw, const Shape& shape, const Uv<double>& p) {
  const auto about = [&](int halvings) { return loop_about(shape, p, halvings); };
  Trim trim;
  const auto add_hole_or_island = [&](const Loop& loop) {
    if (draw.coin()) trim.push_back(about(0));
    trim.push_back(loop);
    return trim;
  };
  switch (place) {
    case Place::kInside:
      return {about(draw.integer(1, 10))};
    case Place::kOnEdge:
      return add_hole_or_island(draw_loop_through(draw, shape, p, false));
    case Place::kOnVertex:
      return add_hole_or_island(draw_loop_through(draw, shape, p, true));
    case Place::kFloatInside:
    case Place::kFloatOutside:
      return add_hole_or_island(draw_loop_beside(draw, shape, p));
    case Place::kInSliver:
      return draw_sliver(draw, shape, p);
    case Place::kAtTouchingLoops:
      trim.push_back(draw_loop_through(draw, shape, p, true));
      trim.push_back(draw_loop_through(draw, shape, p, draw.coin()));
      return trim;
    case Place::kOnIsland:
      for (int i = 0, depth = 0; i < 3; ++i) trim.push_back(about(depth += draw.integer(1, 3)));
      return trim;
    case Place::kInHole:
      break;
  }
  // At the rim of the domain a point is in no hole; there the region is somewhere else.
  trim = {about(0), about(draw.integer(1, 4))};
  if (draw.coin()) trim = {draw_loop_through(draw, shape, trim[0][draw.below(3)], true)};
  return trim;
}

bool is_on_loop(const Trim& trim, const Uv<double>& p) {
  return std::ranges::any_of(trim, [&](const Loop& loop) { return place_of(p, loop) == 0; });
}

/// Gives patch `side` loops with the contact at one of the places. Returns that.
template <class PickPlace>
Place trim_about(Contact& q, std::size_t side, const PickPlace& pick, Draw& draw) {
  MovingPatch<double>& patch = q.query.patches[side];
  const Uv<double> p = {*q.uv[side][0].to_double_exactly(), *q.uv[side][1].to_double_exactly()};
  return draw.until(
      [&] {
        const Place place = pick();
        patch.trim = draw_loops(place, draw, patch.shape, p);
        turn_round(patch.trim, draw);
        return place;
      },
      [&](Place place) {
        const bool is_outside = place == Place::kFloatOutside || place == Place::kInHole;
        if (fault_of(patch.trim, patch.shape) || is_in_trims(q) == is_outside) return false;
        return place != Place::kFloatInside || !is_on_loop(patch.trim, p);
      });
}

/// Gives patch 1 a velocity on top, and moves it so that it is where it was at t*. So it touches
/// patch 2 at another place later, a vertex of a loop. That is t_max then. False if a number is no
/// double.
bool touch_later(Contact& q, Draw& draw) {
  Contact later = q;
  const int halvings = draw.integer(4, 9);
  later.t += Dyadic(Integer(1), -halvings);
  for (std::size_t s = 0; s < 2; ++s) {
    const MovingPatch<double>& patch = q.query.patches[s];
    if (patch.trim.empty()) {
      later.uv[s] = draw_uv(draw, patch.shape, 2);
      continue;
    }
    const Uv<double>& vertex = patch.trim.back()[2];
    later.uv[s] = {Dyadic::exact(vertex[0]), Dyadic::exact(vertex[1])};
  }
  const Vec3<Dyadic> speed = later.offset() * Dyadic(-1, halvings), start = speed * -q.t;
  MovingPatch<double>& patch = later.query.patches[0];
  if (!add_exactly(patch.positions, start) || !add_exactly(patch.velocities, speed)) return false;
  later.query.t_max = *later.t.to_double_exactly();
  q = later;
  return is_valid(q.query);
}

}  // namespace

/// A regular one-sided case with loops about the contact, of one surface or both. The contact of a
/// positive is inside of a loop, on an edge, on a vertex or one float inside. Or it is in a sliver,
/// where loops touch, or on an island in a hole. Else the whole patches touch one float outside or
/// in a hole at t*. Those with loops touch at another place later, at t_max, which the witness
/// says. A moving plane proves that nothing touches before t*. A negative ends at t*, when only the
/// whole patches touch. A small tree proves it, or a search in exact
/// arithmetic.
Attempted trimmed_case(const GeneratorOptions& options, Draw& draw) {
  CCDFUZZ_TRY(const Case regular, plain_case(Family::kRegular, options, draw));
  Contact q = *contact_of(regular);
  const auto is_surface = [&](std::size_t s) {
    return q.query.patches[s].shape.parameter_count() == 2;
  };
  const std::size_t first = is_surface(0) && (!is_surface(1) || draw.coin()) ? 0 : 1;
  const bool is_negative = options.kind == CaseKind::kRN;
  const bool is_outside = is_negative || draw.below(4) == 0;
  // The region of the other patch has the contact.
  if (is_surface(1 - first) && draw.coin()) {
    trim_about(
        q, 1 - first, [&] { return draw.pick(kPlacesOfContacts); }, draw);
  }
  trim_about(
      q, first,
      [&] {
        if (!is_outside) return draw.pick(kPlacesOfContacts);
        return is_negative || draw.coin() ? Place::kInHole : Place::kFloatOutside;
      },
      draw);
  Case out = regular;
  if (is_outside && !is_negative && !touch_later(q, draw)) {
    return tl::unexpected(Discard::kRoundTrip);
  }
  out.query = q.query;
  Truth& truth = out.truth;
  if (!is_negative) {
    truth.witness = q.witness();
    if (!check_clearance(out.query, *truth.clearance)) {
      return tl::unexpected(Discard::kFirstContact);
    }
    return out;
  }
  truth = absence_by_tree(out.query);
  if (truth.collides == false) return out;
  return proven_apart(std::move(out), options);
}

/// True iff a patch may be trimmed.
bool have_a_surface(ContactClass, const ShapePair& shapes) {
  return shapes[0].parameter_count() == 2 || shapes[1].parameter_count() == 2;
}

}  // namespace ccdfuzz
