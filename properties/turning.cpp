#include "ccd/nearest_points.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/checker/spin.hpp"
#include "certify/oracle/oracle.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "generators/draw_patch.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_turning(Draw& d, CaseKind kind) {
  const bool spins = d.below(3) == 0;
  const bool in_plane = !spins && d.coin();
  return draw_planted(d, kind, spins ? Family::kSpinning : Family::kTurning, in_plane);
}

/// Nearest points in exact arithmetic are no contact at any time that is said to be clear.
void check_clear_time(Draw& d) {
  const Case known = draw_turning(d, d.coin() ? CaseKind::kRP : CaseKind::kRN);
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
  Query query = draw_planted(d, d.pick(kBodyCaseKinds)).query;
  query.t_max = std::min(query.t_max, 1.0);
  const Truth plain = decide(query).truth;
  MovingPatch<double>& body = query.patches[d.below(2)];
  const double length = d.integer(1, 8);
  body.turn =
      d.pick(std::array{BodyTurn{{length, 0, 0, 0}, {1, 0, 0, 0}}, BodyTurn{{length, 0}, {1, 0}},
                        BodyTurn{{}, {}, {0, 0, 0}, {0, 0, 0}}});
  for (int k = 0; k < 3; ++k) body.turn->centre[k] = d.integer(-8, 8);
  show(d, "query", query);
  const Truth turned = decide(query).truth;
  suppose(turned.collides.has_value());
  claim_same_time(plain, turned);
}

/// No planes are a proof of the time of a contact.
void check_late_planes(Draw& d) {
  const Case known = draw_turning(d, CaseKind::kRP);
  BodyPlanes planes = std::get<BodyPlanes>(*known.truth.clearance);
  planes.until = known.truth.witness->t;
  if (d.coin()) planes.until += (1 - planes.until) * d.integer(0, 64) / 64;
  BodyPlanes::Plane& last = planes.planes.back();
  const auto change = [&](Rational& x) {
    if (d.below(3) > 0) return;
    x = d.coin() ? Rational(-x) : Rational(x + d.dyadic(8, d.integer(-60, 2)).rational());
  };
  for (auto& normal : last.normals) {
    for (Rational& x : normal) change(x);
  }
  for (Rational& x : last.offsets) change(x);
  change(last.gap);
  if (planes.planes.size() > 1 && d.coin()) planes.planes.pop_back();
  CLAIM(!check_clearance(known.query, planes));
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
         const Case known = draw_turning(d, d.coin() ? CaseKind::kRP : CaseKind::kRN);
         claim_same_otherwise(d, known.query, known.truth);
       }},
      {"turning.no_turn", "Bodies whose turn is the identity touch when they do without it",
       kDeciding, check_no_turn},
      {"checker.refuses_late_planes", "No planes keep bodies that turn apart at their contact",
       kChecker, check_late_planes},
  };
}

}  // namespace ccdfuzz
