#include "certify/checker/check_case.hpp"
#include "certify/checker/check_truth.hpp"
#include "certify/linear/first_contact.hpp"
#include "certify/oracle/complete_truth.hpp"
#include "certify/oracle/decide_linear.hpp"
#include "generators/draw_contact.hpp"
#include "generators/similar.hpp"
#include "properties/draw_linear.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// k·2^-e, of either sign; 0 is not rare.
Rational draw_step(Draw& choices, int most_bits) {
  const int steps = choices.integer(-2, 2);
  return steps * power_of_two(-choices.integer(0, most_bits));
}

/// A linear query with the checker's own decision: clear up to its first contact, and the witness.
/// If the contact is at an irrational time, it may have the root instead.
Case draw_linear_proofs(Draw& choices) {
  Case proven;
  proven.query = supposed(draw_linear(choices));
  Truth& truth = proven.truth;
  const Truth decided = decide_linear(proven.query, {}).truth;
  truth.witness = decided.witness;
  truth.contact_root = decided.contact_root;
  LinearClearance clearance{exact(proven.query.t_max), choices.coin()};
  if (truth.witness || truth.contact_root) {
    const Rational first = decided.clear_until.value_or(0);
    if (clearance.closed) {
      clearance = {first / 2, first > 0};
    } else {
      clearance.until = first;
    }
  }
  truth.clearance = clearance;
  return proven;
}

/// A case with what it proves, a contact, its absence or both, and nothing that it says. A tree
/// is not known: check_absence gets as far as that.
Case draw_proofs(Draw& choices) {
  enum class Source : std::uint8_t { kGenerated, kContact, kLinear, kTree };
  const Source source = choices.pick(
      std::array{Source::kGenerated, Source::kContact, Source::kLinear, Source::kTree});
  if (source == Source::kLinear) return draw_linear_proofs(choices);
  if (source == Source::kContact) return supposed(draw_contact(choices, {}));
  Case made = draw_generated(choices);
  if (source == Source::kTree && made.truth.clear_until) {
    made.truth.clearance = MissTree{*made.truth.clear_until, {}};
  }
  return made;
}

/// When the contact has come, if one is proven: by one proof, where cases are drawn here.
const Rational* contact_time(const Truth& truth) {
  if (truth.witness) return &truth.witness->t;
  return truth.contact_root ? &truth.contact_root->by : nullptr;
}

/// A time that the case's proofs are about.
Rational draw_proven_time(Draw& choices, const Case& proven) {
  const Truth& truth = proven.truth;
  const Rational* const contact = contact_time(truth);
  const bool of_contact = choices.coin();
  if (contact != nullptr && (of_contact || !truth.clearance)) return *contact;
  return truth.clearance ? until_of(*truth.clearance) : exact(proven.query.t_max);
}

/// Whether the proofs of contact bear what a case says.
bool contact_bears(const Case& claim) {
  const Truth& truth = claim.truth;
  const Rational t_max = exact(claim.query.t_max);
  const Rational* const contact = contact_time(truth);
  const bool touches = contact != nullptr && *contact <= t_max;
  if (truth.collides && *truth.collides != touches) return false;
  if (!truth.clear_until) return true;
  return *truth.clear_until >= 0 && (contact == nullptr || *truth.clear_until <= *contact);
}

/// Whether the clearance, which is open at its end or closed, bears what a case says of absence.
bool clearance_bears(const Case& claim) {
  const Truth& truth = claim.truth;
  if (!truth.clearance) return false;
  const Rational& until = until_of(*truth.clearance);
  const bool open = std::holds_alternative<MovingPlane>(*truth.clearance) ||
                    (std::holds_alternative<LinearClearance>(*truth.clearance) &&
                     !std::get<LinearClearance>(*truth.clearance).closed);
  const Rational t_max = exact(claim.query.t_max);
  const bool reaches = open ? t_max < until : t_max <= until;
  if (truth.collides == false && !reaches) return false;
  return !truth.clear_until || *truth.clear_until <= until;
}

bool absence_is_accepted(const Case& claim) {
  const auto checked = check_absence(claim);
  return checked || checked.error().where == "truth.certificate.clear.tree";
}

/// A case that is proven, asked up to another time, and with other things said of it.
void check_claims_of_case(Draw& d) {
  Case claim = draw_proofs(d);
  const Rational end = draw_proven_time(d, claim);
  claim.query.t_max = draw_double_near(d, end);
  constexpr std::array<std::optional<bool>, 3> kSaid = {std::nullopt, false, true};
  claim.truth.collides = d.pick(kSaid);
  claim.truth.clear_until.reset();
  if (d.coin()) {
    constexpr int kMostBits = 60;
    const Rational near = draw_proven_time(d, claim);
    const Rational until = near + draw_step(d, kMostBits);
    claim.truth.clear_until = until;
  }
  show(d, "case", claim);
  CLAIM(check_truth(claim).has_value() == contact_bears(claim));
  CLAIM(absence_is_accepted(claim) == clearance_bears(claim));
}

/// Absence until some time, said and proven or not, of a linear query with an exact first contact.
void check_completed(Draw& d) {
  Case claim;
  claim.query = supposed(draw_linear(d));
  const Rational t_max = exact(claim.query.t_max);
  auto contact = linear::first_contact(linear::exact_patches(claim.query), 2 * t_max);
  if (contact) contact->narrow(power_of_two(-64));
  const auto after = [&](const Rational& t) {
    return contact ? contact->sign_of(linear::Polynomial({-t.get_num(), t.get_den()})) : 1;
  };
  // A contact at a number of eighths refutes proofs up to a later time quickly.
  const bool is_known = !contact || contact->is_rational();
  const Rational until =
      (contact ? contact->lo() : t_max) * 8 / static_cast<long>(d.integer(is_known ? 4 : 9, 16));
  Truth& truth = claim.truth;
  bool is_false = false;
  if (d.coin()) {
    truth.collides = false;
    is_false = after(t_max) <= 0;
  }
  if (d.coin()) {
    truth.clear_until = until;
    is_false |= after(until) < 0;
  }
  if (d.coin()) {
    const bool closed = d.coin();
    truth.clearance = LinearClearance{until, closed};
    is_false |= after(until) < (closed ? 1 : 0);
    // It is no proof of all that is said then.
    is_false |= truth.collides == false && (closed ? until < t_max : until <= t_max);
  }
  show(d, "case", claim);
  const Completed completed = complete_truth(claim);
  show(d, "completed", completed.value);
  CLAIM(completed.refuted == is_false);
  CLAIM(completed.value.truth.collides == (after(t_max) <= 0));
  CLAIM(check_case(completed.value).has_value());
}

/// The same motion from another time on. Discarded if it takes numbers that no double holds.
void begin_at(Case& moving, const Rational& start) {
  moving.query = supposed(begun_at(moving.query, start));
  if (moving.truth.witness) moving.truth.witness->t -= start;
  if (moving.truth.clearance) std::get<MovingPlane>(*moving.truth.clearance).until -= start;
}

void check_other_start(Draw& d) {
  Case moved = d.coin() ? draw_generated(d) : supposed(draw_contact(d, {}));
  moved.truth.collides.reset();
  moved.truth.clear_until.reset();
  constexpr int kMostBits = 8;
  const Rational time = draw_proven_time(d, moved);
  begin_at(moved, time + draw_step(d, kMostBits));
  const auto& witness = moved.truth.witness;
  const auto& clearance = moved.truth.clearance;
  show(d, "case", moved);
  CLAIM(check_truth(moved).has_value() == (!witness || witness->t >= 0));
  if (!clearance) return;
  CLAIM(check_clearance(moved.query, *clearance).has_value() == (until_of(*clearance) >= 0));
}

}  // namespace

std::vector<Property> untrue_cases_claims() {
  return {
      {"checker.refuses_wrong_claims",
       "What a case says of collision up to any t_max and of clear_until is accepted iff the times "
       "of its contact and of its clearance bear it",
       "src/certify/checker/check_truth.hpp", check_claims_of_case},
      {"checker.refuses_proofs_before_start",
       "Witness and plane of a motion are accepted of the same motion from another time on, and "
       "refused iff what they prove comes before t = 0 then",
       "src/certify/checker/check_witness.hpp", check_other_start},
      {"oracle.refutes_untrue_claims",
       "What a case claims of absence is refuted iff a contact or its own proof is against it, and "
       "what stands in its place is proven",
       "src/certify/oracle/complete_truth.hpp", check_completed},
  };
}

}  // namespace ccdfuzz
