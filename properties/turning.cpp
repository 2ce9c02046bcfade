#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/check_turning.hpp"
#include "certify/checker/spin.hpp"
#include "certify/oracle/nearest_points.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "files/case_json.hpp"
#include "generators/draw_patch.hpp"
#include "numeric/products.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_turning(Draw& d, CaseKind kind) {
  const bool spins = d.below(3) == 0;
  const bool in_plane = !spins && d.coin();
  return draw_planted(d, kind, spins ? Family::kSpinning : Family::kTurning, in_plane);
}

CaseKind draw_kind_of_turning(Draw& d) {
  return d.coin() ? CaseKind::kRP : CaseKind::kRN;
}

/// Nearest points in exact arithmetic are no contact at any time that is said to be clear.
void check_clear_time(Draw& d) {
  const Case known = draw_turning(d, draw_kind_of_turning(d));
  constexpr int kSteps = 64;
  const long step = d.integer(0, kSteps);
  // Few bits, lest exact nearest points take seconds.
  const Rational t = rounded_down(*known.truth.clear_until * step / kSteps, power_of_two(-10));
  show(d, "t", t);
  std::array<Points<Rational>, 2> points;
  for (size_t s = 0; s < 2; ++s) points[s] = points_at(known.query.patches[s], t).rational();
  NearestPoints nearest;
  const NearestPoints::Found& found = nearest(points[0], points[1]);
  const Rational reach =
      exact(known.query.patches[0].radius) + exact(known.query.patches[1].radius);
  CLAIM(found.squared > reach * reach);
  // Nor are points deeper in each body, about which it holds larger balls.
  const Rational share = Rational(d.integer(0, kSteps)) / kSteps;
  Witness forged{t, {}, found.weights};
  for (std::vector<Rational>& weights : forged.weights) {
    const auto count = static_cast<long>(weights.size());
    for (Rational& w : weights) w = (1 - share) * w + share / count;
  }
  CLAIM(!check_body_contact(known.query, forged));
}

/// The oracle finds the planted contact of bodies that it does not know.
void check_oracle_finds_turning(Draw& d) {
  const Case known = draw_turning(d, CaseKind::kRP);
  const Truth found = decide(known.query).truth;
  show(d, "found", Case{known.query, found, {}, {}});
  suppose(found.collides.has_value());
  claim_same_time(known.truth, found);
  CLAIM(check_case({known.query, found, {}, {}}).has_value());
  const Rational& t = found.witness->t;
  CLAIM(t - *found.clear_until <= t * power_of_two(-38));
}

/// A turn that goes nowhere is none.
void check_no_turn(Draw& d) {
  const CaseKind kind = d.pick(std::array{CaseKind::kRP, CaseKind::kRN, CaseKind::kNMN});
  Query query = draw_planted(d, kind).query;
  query.t_max = std::min(query.t_max, 1.0);
  const Truth plain = decide(query).truth;
  MovingPatch<double>& body = query.patches[d.below(2)];
  const double length = static_cast<double>(d.integer(1, 8));
  body.turn =
      d.pick(std::array{BodyTurn{{length, 0, 0, 0}, {1, 0, 0, 0}}, BodyTurn{{length, 0}, {1, 0}},
                        BodyTurn{{}, {}, {0, 0, 0}, {0, 0, 0}}});
  for (int k = 0; k < 3; ++k) body.turn->centre[k] = static_cast<double>(d.integer(-8, 8));
  show(d, "query", query);
  const Truth turned = decide(query).truth;
  suppose(turned.collides.has_value());
  claim_same_time(plain, turned);
}

/// Along a normal the highest point of body 1 and the lowest of body 2, in exact arithmetic.
std::array<Rational, 2> heights_at(const Query& query, const Vec3<Rational>& normal,
                                   const Rational& t) {
  std::array<Rational, 2> heights;
  for (size_t s = 0; s < 2; ++s) {
    const Points<Rational> points = points_at(query.patches[s], t).rational();
    heights[s] = dot(normal, points[0]);
    for (const Vec3<Rational>& p : points) {
      const Rational height = dot(normal, p);
      if (s == 0 ? height > heights[s] : height < heights[s]) heights[s] = height;
    }
  }
  return heights;
}

/// A plane that touches a body at both of its ends is accepted only if both bodies are on their
/// sides of it in between. Often it touches the other one, too. Its normal is about the shortest
/// way from body 1 to body 2 at first.
void check_planes_between(Draw& d) {
  const Query query = draw_turning(d, CaseKind::kRP).query;
  constexpr int kSteps = 64;
  BodyPlanes::Plane plane;
  // Few bits, lest exact nearest points take seconds.
  plane.from = rounded_down(exact(query.t_max) * static_cast<long>(d.integer(0, kSteps)) / kSteps,
                            power_of_two(-10));
  NearestPoints nearest;
  const Vec3<Rational> way = nearest(points_at(query.patches[0], plane.from).rational(),
                                     points_at(query.patches[1], plane.from).rational())
                                 .way;
  Vec3<Rational> normal;
  Rational largest = 0;
  for (int k = 0; k < 3; ++k) {
    normal[k] = exact(way[k].get_d());
    largest = std::max(largest, Rational(abs(normal[k])));
    for (auto& end : plane.normals) end[static_cast<size_t>(k)] = normal[k];
  }
  const Rational reach = exact(query.patches[0].radius) + exact(query.patches[1].radius);
  const Rational kept = reach * root_above(dot(normal, normal));
  const Rational length = power_of_two(-static_cast<long>(d.integer(1, 6)));
  const Rational until = plane.from + length;
  suppose(until <= 1);
  const std::array ends = {heights_at(query, normal, plane.from), heights_at(query, normal, until)};
  const bool touches_first = d.coin();
  plane.gap = kept + power_of_two(-20) * largest;
  const Rational room = std::min<Rational>(ends[0][1] - ends[0][0], ends[1][1] - ends[1][0]);
  if (d.coin()) plane.gap = std::max(plane.gap, room);
  for (size_t end = 0; end < 2; ++end) {
    plane.offsets[end] = touches_first ? ends[end][0] : Rational(ends[end][1] - plane.gap);
  }
  suppose(check_body_plane(query, plane, until).has_value());
  constexpr long kParts = 8;
  const Rational share = Rational(static_cast<long>(d.integer(1, kParts - 1))) / kParts;
  const Rational t = plane.from + share * length;
  const Rational offset = (1 - share) * plane.offsets[0] + share * plane.offsets[1];
  const auto [highest, lowest] = heights_at(query, normal, t);
  show(d, "t", t);
  // Where |q| is not rational, points are within 2^-96 of their distance from the centre.
  const Rational rounding = power_of_two(-60) * largest;
  CLAIM(highest <= offset + rounding);
  CLAIM(lowest + rounding >= offset + plane.gap);
}

/// No planes are a proof of the time of a contact.
void check_late_planes(Draw& d) {
  const Case known = draw_turning(d, CaseKind::kRP);
  BodyPlanes planes = std::get<BodyPlanes>(*known.truth.clearance);
  planes.until = known.truth.witness->t;
  if (d.coin()) planes.until += (1 - planes.until) * static_cast<long>(d.integer(0, 64)) / 64;
  BodyPlanes::Plane& last = planes.planes.back();
  const auto change = [&](Rational& x) {
    if (d.below(3) > 0) return;
    x = d.coin() ? Rational(-x)
                 : Rational(x + d.dyadic(8, static_cast<long>(d.integer(-60, 2))).rational());
  };
  for (auto& normal : last.normals) {
    for (Rational& x : normal) change(x);
  }
  for (Rational& x : last.offsets) change(x);
  change(last.gap);
  if (planes.planes.size() > 1 && d.coin()) planes.planes.pop_back();
  CLAIM(!check_clearance(known.query, planes, ""));
}

}  // namespace

std::vector<Property> turning_claims() {
  constexpr auto kChecker = "src/certify/checker/check_turning.hpp";
  constexpr auto kDeciding = "src/certify/oracle/decide_turning.hpp";
  return {
      {"turning.clear_is_clear",
       "Bodies that turn are apart, in exact arithmetic, at each time that is said to be clear",
       kChecker, check_clear_time},
      {"turning.oracle_finds_contact",
       "The oracle brackets the planted first contact of bodies that turn within 2^-38 of its time",
       kDeciding, check_oracle_finds_turning},
      {"turning.same_contact",
       "Bodies that turn touch at the same time if they are swapped, scaled, given quaternions "
       "of other lengths, or, where they spin, other axes",
       kDeciding,
       [](Draw& d) {
         const Case known = draw_turning(d, draw_kind_of_turning(d));
         claim_same_otherwise(d, known.query, known.truth);
       }},
      {"turning.no_turn", "Bodies whose turn is the identity touch when they do without it",
       kDeciding, check_no_turn},
      {"turning.planes_hold_between",
       "Planes that are accepted have bodies that turn on their sides between their ends, too",
       kChecker, check_planes_between},
      {"checker.refuses_late_planes", "No planes keep bodies that turn apart at their contact",
       kChecker, check_late_planes},
  };
}

}  // namespace ccdfuzz
