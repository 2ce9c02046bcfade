#include "properties/judge_claims.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "properties/draw_contact.hpp"
#include "query/case_json.hpp"
#include "query/judge.hpp"

namespace ccdfuzz {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Answer says(Verdict verdict, std::optional<double> toi) {
  Answer answer;
  answer.verdict = verdict;
  answer.toi = toi;
  return answer;
}

Check judged_so(const Case& asked, const Answer& answer, Outcome expected,
                const AnswerTerms& terms = {}) {
  const Outcome outcome = judge(asked.query, asked.truth, answer, terms);
  if (outcome == expected) return Check::holds();
  return Check::fails(fmt::format("{} with toi {} is {}, not {}, on\n{}",
                                  answer.verdict == Verdict::kHit    ? "a hit"
                                  : answer.verdict == Verdict::kMiss ? "a miss"
                                                                     : "no decision",
                                  answer.toi ? to_hex(*answer.toi) : "none", name_of(outcome),
                                  name_of(expected), to_json(asked)));
}

/// The judge on made-up answers about a proven contact.
Check check_judge(ChoiceSource& choices) {
  const Result<Case> drawn = draw_contact(choices, {});
  if (!drawn) return Check::discarded("a number is not a double");
  const double t = *to_double_exactly(drawn->truth.witness->t), t_max = drawn->query.t_max;
  const auto outcome = [&](Verdict verdict, std::optional<double> toi) {
    return judge(drawn->query, drawn->truth, says(verdict, toi));
  };
  const double after = std::nextafter(t, HUGE_VAL);
  const bool right =
      outcome(Verdict::kMiss, {}) == Outcome::kMissed &&
      outcome(Verdict::kHit, t) == Outcome::kCorrect &&
      outcome(Verdict::kHit, 0) == Outcome::kCorrect &&
      outcome(Verdict::kHit, after) == (after <= t_max ? Outcome::kLate : Outcome::kError) &&
      outcome(Verdict::kHit, {}) == Outcome::kError &&
      outcome(Verdict::kHit, std::nan("")) == Outcome::kError &&
      outcome(Verdict::kHit, std::nextafter(t_max, HUGE_VAL)) == Outcome::kError &&
      outcome(Verdict::kUndecided, {}) == Outcome::kUndecided;
  return right ? Check::holds() : Check::fails(to_json(*drawn));
}

/// What is to be said of an answer that makes sense, from the times of a case: when it touches, up
/// to when it is said not to, end included, and before when it is proven not to.
Outcome outcome_by_times(const Case& known, double t_max, const Answer& answer) {
  const Rational end = exact(t_max);
  const Truth& truth = known.truth;
  const bool hit = answer.verdict == Verdict::kHit;
  if (truth.witness && truth.witness->t <= end) {
    if (!hit) return Outcome::kMissed;
    return exact(*answer.toi) <= truth.witness->t ? Outcome::kCorrect : Outcome::kLate;
  }
  const bool never = truth.collides == false && t_max <= known.query.t_max;
  const bool not_yet = truth.clear_until && end < *truth.clear_until;
  if (!never && !not_yet) return Outcome::kUnknown;
  return hit ? Outcome::kFalsePositive : Outcome::kCorrect;
}

/// An answer that is none, whatever it is about.
Answer draw_nonsense(ChoiceSource& choices, double t_max) {
  Answer answer = says(Verdict::kHit, t_max);
  switch (choices.choose(5)) {
    case 0:
      answer.uv[choices.choose(1)][0] = kNoNumber;
      break;
    case 1:
      answer.uv[choices.choose(1)][1] = kNoNumber;
      break;
    case 2:
      answer.toi = kNoNumber;
      break;
    case 3:
      answer.toi = -std::numeric_limits<double>::denorm_min();
      break;
    case 4:
      answer.toi = std::nextafter(t_max, HUGE_VAL);
      break;
    default:
      answer = says(Verdict::kUndecided, kNoNumber);
      break;
  }
  return answer;
}

/// The judge on made-up answers about a generated case, positive or negative, asked up to a time
/// near one that it says something of.
Check check_judge_of_absence(ChoiceSource& choices) {
  const Case known = draw_generated(choices);
  const Rational said = exact(known.query.t_max);
  const Rational clear = known.truth.clear_until.value_or(said);
  const Rational touch = known.truth.witness ? known.truth.witness->t : said;
  const double t_max = draw_double_near(choices, choices.pick(std::array{clear, said, touch}));
  const double near = draw_double_near(choices, choices.pick(std::array{touch, clear, said}));
  const double toi = std::min(choices.coin() ? near : 0, t_max);
  const Case asked = with_t_max(known, t_max);
  for (const Answer& answer : {says(Verdict::kMiss, {}), says(Verdict::kHit, toi)}) {
    Check check = judged_so(asked, answer, outcome_by_times(known, t_max, answer));
    if (check.status == Check::Status::kFails) return check;
  }
  Check check = judged_so(asked, says(Verdict::kUndecided, toi), Outcome::kUndecided);
  if (check.status == Check::Status::kFails) return check;
  return judged_so(asked, draw_nonsense(choices, t_max), Outcome::kError);
}

/// k·2^-4: what the times of the scenes below are, so that their sums and products are exact.
double sixteenths(std::int64_t k) {
  return std::ldexp(static_cast<double>(k), -4);
}

/// A double, or one next to it.
double draw_next_to(ChoiceSource& choices, double x) {
  const int step = choices.pick(std::array{0, -1, 1});
  return step == 0 ? x : std::nextafter(x, step * HUGE_VAL);
}

/// Two points at the distance 5·size·|t − contact| from each other, size a power of two.
Case points_that_meet(ChoiceSource& choices, double contact, double size) {
  const Vec3<double> away = choices.coin() ? Vec3<double>(3, 4, 0) : Vec3<double>(0, -3, 4);
  Case met;
  for (MovingPatch<double>& patch : met.query.patches) {
    patch.shape = Shape::point();
    patch.positions = {{0, 0, 0}};
    patch.velocities = {{0, 0, 0}};
  }
  met.query.patches[1].positions[0] = away * (size * contact);
  met.query.patches[1].velocities[0] = -away * size;
  met.truth.witness = Witness{exact(contact), {}};
  met.truth.clear_until = exact(contact);
  return met;
}

/// The judge by what a method says of its ends of time, its tolerances in time and the separation
/// that it keeps.
Check check_terms_of_time(ChoiceSource& choices) {
  const double contact = sixteenths(choices.integer(0, 16));
  const double size = std::ldexp(1.0, static_cast<int>(choices.integer(-40, 40)));
  Case asked = points_that_meet(choices, contact, size);
  const double t_max = sixteenths(choices.integer(0, 16));
  asked.query.t_max = t_max;
  const double toi = std::min(sixteenths(choices.integer(0, 16)), t_max);
  const bool hit = choices.coin();
  AnswerTerms terms;
  terms.closed_t_max = !choices.coin();
  terms.contact_at_zero = !choices.coin();
  if (choices.coin()) {
    terms.time_tolerance = std::max(0.0, draw_next_to(choices, std::abs(toi - contact)));
  }
  if (choices.coin()) {
    terms.early_tolerance = std::max(0.0, draw_next_to(choices, std::abs(toi - contact)));
  }
  const double before = hit ? toi : t_max;
  const double nearest = 5 * size * (contact - std::min(before, contact));
  if (choices.coin()) terms.kept_separation = std::max(0.0, draw_next_to(choices, nearest));

  // What is too near at t = 0 may be left out where a contact may be.
  const bool at_zero = 5 * size * contact < terms.kept_separation;
  const bool too_near =
      before > 0 && nearest < terms.kept_separation && (terms.contact_at_zero || !at_zero);
  const bool counts = contact <= t_max && (terms.closed_t_max || contact < t_max) &&
                      (terms.contact_at_zero || contact > 0);
  const bool late = hit && toi > contact && toi - contact > terms.time_tolerance;
  const bool early = contact > toi && contact - toi > terms.early_tolerance;
  Outcome expected = Outcome::kUnknown;
  if (too_near || counts) {
    expected = !hit ? Outcome::kMissed : too_near || late ? Outcome::kLate : Outcome::kCorrect;
  } else if (contact > t_max) {
    const bool to_come = terms.early_tolerance > 0 && !early;
    expected = hit && !to_come ? Outcome::kFalsePositive : Outcome::kCorrect;
  }
  const auto verdict = hit ? Verdict::kHit : Verdict::kMiss;
  return judged_so(asked, says(verdict, hit ? std::optional(toi) : std::nullopt), expected, terms);
}

/// The judge by what a method says of its tolerance in space: a point that passes a line at five
/// times a power of two.
Check check_terms_of_space(ChoiceSource& choices) {
  const double size = std::ldexp(1.0, static_cast<int>(choices.integer(-40, 40)));
  const double passing = sixteenths(choices.integer(0, 16));
  Case asked;
  auto& [point, line] = asked.query.patches;
  point = {Shape::point(), {{-passing * size, 0, 0}}, {{size, 0, 0}}};
  line = {Shape::curve(1), {{0, 3 * size, 4 * size}, {size, 3 * size, 4 * size}}, {}};
  line.velocities.resize(2, Vec3<double>(0, 0, 0));
  asked.truth.collides = false;
  Answer answer = says(Verdict::kHit, sixteenths(choices.integer(0, 16)));
  answer.uv[1][0] = sixteenths(choices.integer(-2, 18));
  AnswerTerms terms;
  terms.has_uv = !choices.coin();
  if (choices.coin()) terms.space_tolerance = draw_next_to(choices, 5 * size);

  const bool abreast = *answer.toi - passing == answer.uv[1][0];
  const bool on_line = answer.uv[1][0] >= 0 && answer.uv[1][0] <= 1;
  Outcome expected = Outcome::kFalsePositive;
  if (terms.space_tolerance > 0 && !terms.has_uv) {
    expected = Outcome::kUnknown;
  } else if (abreast && on_line && terms.space_tolerance >= 5 * size) {
    expected = Outcome::kCorrect;
  }
  return judged_so(asked, answer, expected, terms);
}

}  // namespace

std::vector<Property> judge_properties() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr auto kSource = "src/query/judge.hpp";
  return {
      {"judge.sees_misses_and_late_answers",
       "A miss and a toi after a proven contact are false negatives, and nonsense is an error",
       kSource, kHolds, check_judge},
      {"judge.sees_false_positives",
       "A hit is false and a miss right iff absence of contact is proven up to t_max, itself "
       "included, and neither where nothing is proven; NaN in time or place is an error",
       kSource, kHolds, check_judge_of_absence},
      {"judge.keeps_to_terms_of_time",
       "Ends of time, tolerances in time and a separation that is kept count as a method says, to "
       "the last bit",
       kSource, kHolds, check_terms_of_time},
      {"judge.keeps_to_terms_of_space",
       "A hit is false iff it is off by more than the tolerance in space, to the last bit, and "
       "unknown where it does not say where",
       kSource, kHolds, check_terms_of_space},
  };
}

}  // namespace ccdfuzz
