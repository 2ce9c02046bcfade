#include <cmath>
#include <optional>

#include "case/scale.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "properties/planted_bodies.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

Case draw_body_graze(Draw& d, Family family, CaseKind kind) {
  const Case made = draw_planted(d, kind, family);
  claim_planted_truth(made, kind, {.bodies = true});
  return made;
}

/// However bodies turn about the normal of the plane between them, they touch and are never deep.
void check_turning_graze(Draw& d) {
  const bool spins = d.below(8) == 7;  // these take longest to prove
  const Family family = spins ? Family::kSpinningGrazing : Family::kTurningGrazing;
  const Case known = draw_body_graze(d, family, CaseKind::kRP);
  CLAIM(has_turns(known.query));
  CLAIM(has_spins(known.query) == spins);
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
  const Case known = draw_body_graze(d, family, CaseKind::kNMN);
  Query nearer = known.query;
  nearer.separation = std::ldexp(largest_coordinate(known.query), -16);
  // The oracle may leave it undecided where bodies turn.
  const std::optional<bool> collides = decide(nearer).truth.collides;
  suppose(collides.has_value());
  CLAIM(*collides);
}

}  // namespace

std::vector<Property> grazes_claims() {
  return {
      {"bodies.graze_as_they_turn",
       "Bodies that turn or spin about the normal of the plane between them touch without depth",
       "generators/turning.hpp", check_turning_graze},
      {"bodies.just_miss",
       "Bodies that just miss are proven apart, by no more than 2^-16 of the largest coordinate",
       "generators/just_missing.hpp", check_just_missing},
  };
}

}  // namespace ccdfuzz
