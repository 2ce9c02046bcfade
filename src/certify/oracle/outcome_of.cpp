#include "certify/oracle/outcome_of.hpp"

#include "case/mesh.hpp"
#include "certify/oracle/body_depth.hpp"
#include "certify/oracle/oracle.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

namespace {

/// What of a hit is unknown only because a contact may come within the early tolerance after it.
/// Where that can be decided, it is.
Outcome outcome_of_early(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms) {
  AnswerTerms strict = terms;
  strict.early_tolerance = 0;
  if (judge(known, answer, strict) != Outcome::kFalsePositive ||
      !is_decided_exactly(known.query())) {
    return Outcome::kUnknown;
  }
  Query longer = known.query();
  longer.t_max = round_up(early_until(longer, answer, terms));
  const std::optional<bool> collides = decide(longer).truth.collides;
  return !collides ? Outcome::kUnknown : *collides ? Outcome::kCorrect : Outcome::kFalsePositive;
}

}  // namespace

Outcome outcome_of(const CheckedCase& known, const Answer& answer, const AnswerTerms& terms,
                   bool is_ordinary) {
  const Outcome outcome = judge(known, answer, terms);
  const Query& query = known.query();
  if (outcome == Outcome::kUnknown && terms.early_tolerance > 0) {
    return outcome_of_early(known, answer, terms);
  }
  const double tolerance = terms.depth_tolerance;
  if (!is_false_negative(outcome) || !is_of_bodies(query)) return outcome;
  // A graze before a deep contact of a mesh is not ordinary, and hits of the deep one may be so
  // late. Nor is a touch at the start that has no depth.
  const bool starts_in_contact = *known.contact_by() == 0;
  const bool may_graze = is_ordinary && (has_mesh(query) || starts_in_contact);
  if (!(tolerance > 0) && !may_graze) return outcome;
  const Rational speed = greatest_speed(query);
  Rational most = exact(tolerance);
  if (may_graze) most += exact(terms.time_tolerance) * speed;
  // Moved back by so much, they would not touch: no overlap is deeper than the way, but one at the
  // start. A hit after that is late by no more than the way.
  const bool is_late = outcome == Outcome::kLate;
  const double until = is_late ? *answer.toi : query.t_max;
  const Rational overlooked = is_late ? exact(until) - *known.contact_by() : exact(until);
  if ((is_late || !starts_in_contact) && speed * overlooked <= most) return Outcome::kCorrect;
  const std::optional<bool> is_deeper = is_deeper_until(query, until, most, terms.in_plane);
  if (!is_deeper) return Outcome::kUnknown;
  return *is_deeper ? outcome : Outcome::kCorrect;
}

}  // namespace ccdfuzz
