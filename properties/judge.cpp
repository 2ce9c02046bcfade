#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "case/case_json.hpp"
#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "generators/draw_contact.hpp"
#include "method/plugin/plugin_terms.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Answer says(Verdict verdict, std::optional<double> toi) {
  Answer answer;
  answer.verdict = verdict;
  answer.toi = toi;
  return answer;
}

Check judged_so(const CheckedCase& asked, const Answer& answer, Outcome expected,
                const AnswerTerms& terms = {}) {
  const Outcome outcome = judge(asked, answer, terms);
  if (outcome == expected) return Check::holds();
  return Check::fails(fmt::format("{} with toi {} is {}, not {}, on\n{}", name_of(answer.verdict),
                                  answer.toi ? to_hex(*answer.toi) : "none", name_of(outcome),
                                  name_of(expected), to_json(asked.value())));
}

/// The judge on made-up answers about a proven contact.
Check check_judge(Draw& choices) {
  const Result<Case> drawn = draw_contact(choices, {});
  if (!drawn) return Check::discarded("a number is not a double");
  const double t = *to_double_exactly(drawn->truth.witness->t), t_max = drawn->query.t_max;
  const CheckedCase known = checked_contact(*drawn);
  const auto outcome = [&](Verdict verdict, std::optional<double> toi) {
    return judge(known, says(verdict, toi));
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
      outcome(Verdict::kUndecided, {}) == Outcome::kUndecided &&
      outcome(Verdict::kRefused, {}) == Outcome::kNotAsked;
  return right ? Check::holds() : Check::fails(to_json(*drawn));
}

/// What is to be said of an answer that makes sense, from the times of a case: when it touches, and
/// before when a plane proves that it does not. What it says besides, without a certificate, counts
/// for nothing.
Outcome outcome_by_times(const Case& known, double t_max, const Answer& answer) {
  const Rational end = exact(t_max);
  const Truth& truth = known.truth;
  const bool hit = answer.verdict == Verdict::kHit;
  if (truth.witness && truth.witness->t <= end) {
    if (!hit) return Outcome::kMissed;
    return exact(*answer.toi) <= truth.witness->t ? Outcome::kCorrect : Outcome::kLate;
  }
  if (!truth.clearance || end >= until_of(*truth.clearance)) return Outcome::kUnknown;
  return hit ? Outcome::kFalsePositive : Outcome::kCorrect;
}

/// An answer that is none, whatever it is about.
Answer draw_nonsense(Draw& choices, double t_max) {
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
Check check_judge_of_absence(Draw& choices) {
  const Case known = draw_generated(choices);
  const Rational said = exact(known.query.t_max);
  const Rational clear = known.truth.clear_until.value_or(said);
  const Rational touch = known.truth.witness ? known.truth.witness->t : said;
  const double t_max = draw_double_near(choices, choices.pick(std::array{clear, said, touch}));
  const double near = draw_double_near(choices, choices.pick(std::array{touch, clear, said}));
  const double toi = std::min(choices.coin() ? near : 0, t_max);
  const CheckedCase asked = checked_or_unknown(known).with_t_max(t_max);
  for (const Answer& answer : {says(Verdict::kMiss, {}), says(Verdict::kHit, toi)}) {
    Check check = judged_so(asked, answer, outcome_by_times(known, t_max, answer));
    if (check.status == Check::Status::kFails) return check;
  }
  Check check = judged_so(asked, says(Verdict::kUndecided, toi), Outcome::kUndecided);
  if (check.status == Check::Status::kFails) return check;
  check = judged_so(asked, says(Verdict::kRefused, kNoNumber), Outcome::kNotAsked);
  if (check.status == Check::Status::kFails) return check;
  return judged_so(asked, draw_nonsense(choices, t_max), Outcome::kError);
}

/// k·2^-4: what the times of the scenes below are, so that their sums and products are exact.
double sixteenths(std::int64_t k) {
  return std::ldexp(static_cast<double>(k), -4);
}

/// A double, or one next to it.
double draw_next_to(Draw& choices, double x) {
  const int step = choices.pick(std::array{0, -1, 1});
  return step == 0 ? x : std::nextafter(x, step * HUGE_VAL);
}

/// Two points at the distance 5·size·|t − contact| from each other, size a power of two.
Case points_that_meet(Draw& choices, double contact, double size) {
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
  met.truth.clearance = LinearClearance{exact(contact), false};
  return met;
}

/// The judge by what a method says of its ends of time, its tolerances in time and the separation
/// that it keeps.
Check check_terms_of_time(Draw& choices) {
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
  return judged_so(checked_or_unknown(asked),
                   says(verdict, hit ? std::optional(toi) : std::nullopt), expected, terms);
}

/// The judge by what a method says of its tolerance in space: a point that passes a line at five
/// times a power of two.
Check check_terms_of_space(Draw& choices) {
  const double size = std::ldexp(1.0, static_cast<int>(choices.integer(-40, 40)));
  const double passing = sixteenths(choices.integer(0, 16));
  Case asked;
  auto& [point, line] = asked.query.patches;
  point = {Shape::point(), {{-passing * size, 0, 0}}, {{size, 0, 0}}};
  line = {Shape::curve(1), {{0, 3 * size, 4 * size}, {size, 3 * size, 4 * size}}, {}};
  line.velocities.resize(2, Vec3<double>(0, 0, 0));
  asked.truth.collides = false;
  asked.truth.proof = "L";
  asked.truth.clearance = LinearClearance{exact(asked.query.t_max), true};
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
  return judged_so(checked_or_unknown(asked), answer, expected, terms);
}

/// A case about two points that meet once, which says what is false or has no proof.
Case draw_unproven(Draw& choices) {
  const double contact = sixteenths(choices.integer(1, 16));
  const double size = std::ldexp(1.0, static_cast<int>(choices.integer(-40, 40)));
  Case lie = points_that_meet(choices, contact, size);
  lie.query.t_max = sixteenths(choices.integer(0, 32));
  const Rational half = exact(contact / 2);
  const Rational later = exact(contact + sixteenths(choices.integer(1, 16)));
  Truth& truth = lie.truth;
  truth = {};
  switch (choices.choose(5)) {
    case 0:
      truth.witness = Witness{choices.coin() ? later : half, {}};
      break;
    case 1:
      truth.clearance = LinearClearance{later, choices.coin()};
      break;
    case 2:
      truth.clearance = LinearClearance{exact(contact), true};
      break;
    case 3:
      truth.clearance = MovingPlane{later, {}, 0};
      for (Rational& x : std::get<MovingPlane>(*truth.clearance).normal) {
        x = Rational(choices.integer(-2, 2));
      }
      break;
    case 4:  // a proof of less than is said
      truth.clearance = LinearClearance{half, false};
      truth.clear_until = later;
      break;
    default:  // the word of a method, which may be true
      truth.clear_until = later;
      break;
  }
  const Rational end = exact(lie.query.t_max);
  if (truth.witness && truth.witness->t <= end) truth.collides = true;
  if (!truth.witness && end < later) {
    truth.collides = false;
    truth.proof = truth.clearance ? proof_word(*truth.clearance) : "rational-tdibm";
  }
  return lie;
}

/// The judge on what a file may say.
Check check_unproven(Draw& choices) {
  const Case lie = draw_unproven(choices);
  for (const Answer& answer : {says(Verdict::kMiss, {}), says(Verdict::kHit, 0)}) {
    Check check = judged_so(checked_or_unknown(lie), answer, Outcome::kUnknown);
    if (check.status != Check::Status::kFails) continue;
    return Check::fails(check.text + "\nas was said by\n" + to_json(lie));
  }
  return Check::holds();
}

constexpr std::array kToleranceKinds = {ToleranceKind::kTime, ToleranceKind::kTimeRelative,
                                        ToleranceKind::kSpace, ToleranceKind::kSpaceRelative};

bool is_looser(const AnswerTerms& a, const AnswerTerms& b) {
  return a.time_tolerance > b.time_tolerance || a.space_tolerance > b.space_tolerance ||
         a.early_tolerance > b.early_tolerance || a.kept_separation < b.kept_separation;
}

/// What a plug-in has achieved beside what it claims.
Check check_achieved(Draw& choices) {
  PluginDescription claims;
  claims.conservative = choices.coin();
  claims.tolerance_kind = choices.pick(kToleranceKinds);
  claims.tolerance = sixteenths(choices.integer(0, 16));
  if (choices.coin()) claims.minimum_separation = sixteenths(choices.integer(0, 16));
  PluginAnswer given;
  given.tolerance = choices.pick(std::array{kNoNumber, HUGE_VAL, 1e300, claims.tolerance / 2,
                                            std::nextafter(claims.tolerance, HUGE_VAL)});
  const Query query = points_that_meet(choices, 1, 1).query;
  const AnswerTerms claimed = terms_of(claims, {}, query);
  const AnswerTerms judged_by = terms_of(claims, given, query);
  PluginDescription tighter = claims;
  tighter.tolerance = std::min(claims.tolerance, given.tolerance);  // of NaN the claimed one
  const AnswerTerms wanted = terms_of(tighter, {}, query);
  const bool is_broken = claims.tolerance > 0 && given.tolerance > claims.tolerance;
  const bool right = !is_looser(judged_by, claimed) && !is_looser(judged_by, wanted) &&
                     !is_looser(wanted, judged_by) &&
                     broken_tolerance(claims, given).has_value() == is_broken;
  if (right) return Check::holds();
  return Check::fails(fmt::format("claims {} ({}), achieved {}", to_hex(claims.tolerance),
                                  name_of(claims.tolerance_kind), to_hex(given.tolerance)));
}

/// Claims about as loose as may be.
Check check_loosest_claims(Draw& choices) {
  const ToleranceKind kind = choices.pick(kToleranceKinds);
  const bool separates = choices.coin();
  const bool relative =
      !separates && (kind == ToleranceKind::kTimeRelative || kind == ToleranceKind::kSpaceRelative);
  const double most = relative ? 1 : 0x1p40;
  const double claimed = choices.pick(std::array{most, most / 2, std::nextafter(most, 0),
                                                 std::nextafter(most, HUGE_VAL), 2 * most, 1e308});
  const std::string line =
      fmt::format(R"({{"protocol":1,"tolerance_kind":"{}","{}":{}}})", name_of(kind),
                  separates ? "minimum_separation" : "tolerance", claimed);
  if (read_description(line).has_value() == (claimed <= most)) return Check::holds();
  return Check::fails(line);
}

}  // namespace

std::vector<Property> judge_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  constexpr auto kSource = "src/case/judge.hpp";
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
      {"judge.believes_nothing_unproven",
       "By a false witness, a false or too short certificate of absence or the word of a method "
       "every answer is unknown",
       "src/certify/checker/check_case.hpp", kHolds, check_unproven},
      {"plugin.achieves_no_looser_tolerance",
       "An answer is judged by the tighter of the claimed and the achieved tolerance, and a looser "
       "one is a broken claim",
       "src/method/plugin/plugin_terms.hpp", kHolds, check_achieved},
      {"plugin.claims_are_limited",
       "A tolerance or separation is accepted iff it is at most 2^40, or 1 where it is relative",
       "src/method/plugin/line_protocol.hpp", kHolds, check_loosest_claims},
  };
}

}  // namespace ccdfuzz
