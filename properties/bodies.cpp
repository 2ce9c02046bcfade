#include <cmath>

#include "case/scale.hpp"
#include "certify/checker/check_bodies.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Query draw_bodies(Draw& d) {
  const Query first = draw_planted(d, d.pick(kBodyCaseKinds)).query;
  return draw_mutant(d, first, draw_planted(d, CaseKind::kRP).query);
}

Rational draw_fraction_of(Draw& d, const Rational& whole) {
  constexpr long kSteps = 64;
  return whole * d.integer(0, kSteps) / kSteps;
}

/// Weights that sum to 1: most of it on one point.
std::vector<Rational> draw_weights(Draw& d, size_t count) {
  std::vector<Rational> weights(count, 0);
  weights[d.below(count)] += Rational(1, 2);
  weights[d.below(count)] += Rational(1, 4);
  weights[d.below(count)] += Rational(1, 4);
  return weights;
}

/// The truth of planted cases holds and survives a file. No graze has a depth that is measured,
/// however bodies turn about the normal of the plane between them.
void check_truth_of_bodies(Draw& d) {
  const bool grazes = d.coin();
  const std::uint64_t motion = d.choose(7);
  const bool turns = motion % 2 == 1, spins = motion == 7;  // these take longest to prove
  const CaseKind kind = grazes  ? CaseKind::kRP
                        : turns ? d.pick(std::array{CaseKind::kRP, CaseKind::kRN})
                                : d.pick(kBodyCaseKinds);
  const bool in_plane = turns && !spins && !grazes && d.coin();
  constexpr std::array<std::array<Family, 3>, 2> kFamilies = {
      {{Family::kBodies, Family::kTurning, Family::kSpinning},
       {Family::kBodiesGrazing, Family::kTurningGrazing, Family::kSpinningGrazing}}};
  const Family family = kFamilies[grazes ? 1 : 0][spins ? 2 : turns ? 1 : 0];
  const Case known = draw_planted(d, kind, family, in_plane);
  CLAIM(has_turns(known.query) == turns && has_spins(known.query) == spins);
  claim_planted_truth(known, kind, {.bodies = true});
  if (!grazes) return;
  CLAIM(known.truth.witness->t > 0);
  CLAIM(depth_until(known.query, known.query.t_max).value_or(0) == 0.0);
}

/// A near miss is proven. It is near: 2^-16 of the largest coordinate would bring the bodies into
/// contact.
void check_just_missing(Draw& d) {
  const bool spins = d.below(16) == 15;  // these take longest to prove
  const Family family = spins      ? Family::kSpinningGrazing
                        : d.coin() ? Family::kTurningGrazing
                                   : Family::kBodiesGrazing;
  const Case known = draw_planted(d, CaseKind::kNMN, family);
  claim_planted_truth(known, CaseKind::kNMN, {.bodies = true});
  Query nearer = known.query;
  nearer.separation = std::ldexp(largest_coordinate(known.query), -16);
  // The oracle may leave it undecided where bodies turn.
  CLAIM(supposed(decide(nearer).truth.collides));
}

/// The oracle says the same of planted bodies, whose first contact it finds exactly.
void check_oracle_agrees(Draw& d) {
  const Case known = draw_planted(d, d.pick(kBodyCaseKinds));
  const Truth found = decide(known.query).truth;
  show(d, "found", Case{known.query, found, {}, {}});
  CLAIM(found.collides == known.truth.collides);
  if (!*found.collides) return;
  CLAIM(found.witness->t == known.truth.witness->t);
  CLAIM(found.clear_until == known.truth.clear_until);
}

/// Any bodies are decided, and closely; what is said is checked against points of the hulls.
void check_any_bodies(Draw& d) {
  const Query query = draw_bodies(d);
  const Truth truth = decide(query).truth;
  show(d, "found", Case{query, truth, {}, {}});
  CLAIM(truth.collides.has_value());
  CLAIM(check_case({query, truth, {}, {}}).has_value());
  if (*truth.collides) {
    const Rational& t = truth.witness->t;
    const Rational width = t - truth.clear_until.value_or(0);
    CLAIM(width <= t * power_of_two(-40));
  }
  if (!truth.clear_until || *truth.clear_until == 0) return;
  Witness false_witness{draw_fraction_of(d, *truth.clear_until), {}};
  suppose(false_witness.t < *truth.clear_until || !*truth.collides);
  for (size_t s = 0; s < 2; ++s) {
    false_witness.weights[s] = draw_weights(d, query.patches[s].positions.size());
  }
  show(d, "no contact", Case{query, {true, false_witness, {}, {}, {}, {}, {}}, {}, {}});
  CLAIM(!check_body_contact(query, false_witness));
}

/// No direction is a proof past a contact, nor at one where the end counts.
void check_late_directions(Draw& d) {
  const Case known = draw_planted(d, CaseKind::kRP);
  BodyClearance clear = std::get<BodyClearance>(*known.truth.clearance);
  const bool is_later = d.coin();
  if (is_later) clear.until += draw_fraction_of(d, clear.until) / 64 + power_of_two(-200);
  clear.closed = !is_later || d.coin();
  if (d.coin()) {
    for (Rational& x : clear.normal) x = d.integer(-8, 8);
  }
  const Rational length = draw_fraction_of(d, 8);
  for (Rational& x : clear.normal) x *= length;
  CLAIM(!check_clearance(known.query, clear));
}

/// No weights that miss 1, are negative or too many make a witness, however near the points are.
void check_forged_weights(Draw& d) {
  Case known = draw_planted(d, CaseKind::kRP);
  known.query.separation = 0x1p30;  // everything is near enough
  Witness& witness = *known.truth.witness;
  CLAIM(check_body_contact(known.query, witness).has_value());
  std::vector<Rational>& weights = witness.weights[d.below(2)];
  const size_t i = d.below(weights.size());
  const Rational little = power_of_two(-d.integer(1, 60));
  switch (d.below(4)) {
    case 0:
      weights[i] += d.coin() ? little : Rational(-little);
      break;
    case 1:
      weights.push_back(0);
      break;
    case 2:
      weights.push_back(-little);
      weights[i] += little;
      break;
    default: {
      suppose(weights.size() > 1);
      const Rational below = weights[i] + little;
      weights[i] -= below;
      weights[(i + 1) % weights.size()] += below;
      break;
    }
  }
  show(d, "forged", known);
  CLAIM(!check_body_contact(known.query, witness));
}

}  // namespace

std::vector<Property> bodies_claims() {
  constexpr auto kChecker = "src/certify/checker/check_bodies.hpp";
  constexpr auto kDeciding = "src/certify/oracle/decide_bodies.hpp";
  return {
      {"bodies.truth_holds",
       "The planted truth of two bodies, also of such as turn or spin, is accepted and survives a "
       "file, grazes are without depth, and methods that do not take bodies say so",
       "generators/bodies.hpp", check_truth_of_bodies},
      {"bodies.just_miss",
       "Bodies that just miss are proven apart, by no more than 2^-16 of the largest coordinate",
       "generators/just_missing.hpp", check_just_missing},
      {"bodies.oracle_agrees", "The oracle finds the planted first contact of bodies, exactly",
       kDeciding, check_oracle_agrees},
      {"bodies.are_decided",
       "Any two bodies are decided, a contact within 2^-40 of its time, and none comes before",
       kDeciding, check_any_bodies},
      {"bodies.same_contact", "Bodies that are swapped and scaled touch at the same time",
       kDeciding,
       [](Draw& d) {
         const Query query = draw_bodies(d);
         claim_same_otherwise(d, query, decide(query).truth);
       }},
      {"checker.refuses_late_directions",
       "A direction that keeps bodies apart is refused past their contact", kChecker,
       check_late_directions},
      {"checker.refuses_forged_weights", "Weights that make no point of a hull are no witness",
       kChecker, check_forged_weights},
  };
}

}  // namespace ccdfuzz
