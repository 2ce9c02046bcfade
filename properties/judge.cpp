#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "case/judge.hpp"
#include "certify/checker/check_case.hpp"
#include "generators/draw_contact.hpp"
#include "method/plugin/plugin_terms.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Answer says(Verdict verdict, double toi) {
  Answer answer;
  answer.verdict = verdict;
  answer.toi = toi;
  return answer;
}

/// Shows the answer; the case is the caller's to show.
void claim_judged(Draw& d, const CheckedCase& asked, const Answer& answer, Outcome expected,
                  const AnswerTerms& terms = {}) {
  const Outcome outcome = show(d, "outcome", judge(asked, answer, terms));
  show(d, "answer", answer.verdict);
  show(d, "toi", answer.toi);
  show(d, "expected", expected);
  CLAIM(outcome == expected);
}

/// What is to be said of an answer that makes sense, from the times of a case. These say when it
/// touches, and before when a plane proves that it does not. What the case says besides, without a
/// certificate, counts for nothing.
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
  const std::array<std::optional<double>, 4> times = {
      kNoNumber, -std::numeric_limits<double>::denorm_min(), std::nextafter(t_max, HUGE_VAL),
      std::nullopt};
  const std::uint64_t kind = choices.choose(6);
  if (kind == 6) return says(Verdict::kUndecided, kNoNumber);
  Answer answer = Answer::hit(t_max);
  if (kind >= 2) {
    answer.toi = times[kind - 2];
  } else {
    answer.uv[choices.choose(1)][kind] = kNoNumber;
  }
  return answer;
}

/// Made-up answers about a generated case, positive or negative, or a contact, asked up to a time
/// near one that it says something of.
void check_judge(Draw& d) {
  const Case known = d.coin() ? draw_generated(d) : supposed(draw_contact(d, {}));
  const Rational said = exact(known.query.t_max);
  const Rational clear = known.truth.clear_until.value_or(said);
  const Rational touch = known.truth.witness ? known.truth.witness->t : said;
  const double t_max = draw_double_near(d, d.pick(std::array{clear, said, touch}));
  const double near = draw_double_near(d, d.pick(std::array{touch, clear, said}));
  const double toi = std::min(d.coin() ? near : 0, t_max);
  const CheckedCase asked = checked_or_unknown(known).with_t_max(t_max);
  show(d, "case", asked.value());
  for (const Answer& answer : {Answer::miss(), Answer::hit(toi)}) {
    claim_judged(d, asked, answer, outcome_by_times(known, t_max, answer));
  }
  claim_judged(d, asked, says(Verdict::kUndecided, toi), Outcome::kUndecided);
  claim_judged(d, asked, says(Verdict::kRefused, kNoNumber), Outcome::kNotAsked);
  claim_judged(d, asked, draw_nonsense(d, t_max), Outcome::kError);
}

/// k·2^-4: what the times of the scenes below are, so that their sums and products are exact.
double sixteenths(std::int64_t k) {
  return std::ldexp(static_cast<double>(k), -4);
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

void check_terms_of_time(Draw& d) {
  const double contact = sixteenths(d.integer(0, 16));
  const double size = std::ldexp(1.0, d.integer(-40, 40));
  Case asked = points_that_meet(d, contact, size);
  const double t_max = sixteenths(d.integer(0, 16));
  asked.query.t_max = t_max;
  const double toi = std::min(sixteenths(d.integer(0, 16)), t_max);
  const bool hit = d.coin();
  AnswerTerms terms;
  terms.closed_t_max = !d.coin();
  terms.contact_at_zero = !d.coin();
  const double off = std::abs(toi - contact);
  if (d.coin()) terms.time_tolerance = std::max(0.0, d.nudged(off, 1));
  if (d.coin()) terms.early_tolerance = std::max(0.0, d.nudged(off, 1));
  // Nobody may know that a contact comes after t_max.
  const bool is_told = contact <= t_max || d.coin();
  if (!is_told) asked.truth.witness.reset();
  const double before = hit ? toi : t_max;
  const double nearest = 5 * size * (contact - std::min(before, contact));
  if (d.coin()) terms.kept_separation = std::max(0.0, d.nudged(nearest, 1));

  // What is too near at t = 0 may be left out where a contact may be.
  const bool at_zero = 5 * size * contact < terms.kept_separation;
  const bool too_near = is_told && before > 0 && nearest < terms.kept_separation &&
                        (terms.contact_at_zero || !at_zero);
  const bool left_out = !hit && !terms.closed_t_max && contact == t_max;
  const bool counts = contact <= t_max && !left_out && (terms.contact_at_zero || contact > 0);
  const bool late = hit && toi > contact && toi - contact > terms.time_tolerance;
  const bool early = contact > toi && contact - toi > terms.early_tolerance;
  Outcome expected = Outcome::kUnknown;
  if (too_near || counts) {
    expected = !hit ? Outcome::kMissed : too_near || late ? Outcome::kLate : Outcome::kCorrect;
  } else if (contact > t_max || left_out) {
    const bool to_come = terms.early_tolerance > 0 && !early;
    expected = hit && !to_come   ? Outcome::kFalsePositive
               : !hit || is_told ? Outcome::kCorrect
                                 : Outcome::kUnknown;
  }
  show(d, "closed_t_max", terms.closed_t_max);
  show(d, "contact_at_zero", terms.contact_at_zero);
  show(d, "time_tolerance", terms.time_tolerance);
  show(d, "early_tolerance", terms.early_tolerance);
  show(d, "kept_separation", terms.kept_separation);
  show(d, "case", asked);
  const Answer answer = hit ? Answer::hit(toi) : Answer::miss();
  const CheckedCase known = checked_or_unknown(asked);
  claim_judged(d, known, answer, expected, terms);
  if (expected != Outcome::kLate) return;
  Rational since = exact(contact);
  if (too_near) since -= exact(terms.kept_separation) / exact(5 * size);
  const double late_by = show(d, "late_by", delay_of(known, answer, terms));
  CLAIM(exact(late_by) >= exact(toi) - std::max(since, Rational(0)));
  CLAIM(late_by <= toi);
}

/// A point that passes a line at five times a power of two; then bodies that do, with radii.
void check_terms_of_space(Draw& d) {
  const double size = std::ldexp(1.0, d.integer(-40, 40));
  const double passing = sixteenths(d.integer(0, 16));
  Case asked;
  auto& [point, line] = asked.query.patches;
  point = {Shape::point(), {{-passing * size, 0, 0}}, {{size, 0, 0}}};
  line = {Shape::curve(1), {{0, 3 * size, 4 * size}, {size, 3 * size, 4 * size}}, {}};
  line.velocities.resize(2, Vec3<double>(0, 0, 0));
  asked.truth.collides = false;
  asked.truth.proof = "L";
  asked.truth.clearance = LinearClearance{exact(asked.query.t_max), true};
  Answer answer = Answer::hit(sixteenths(d.integer(0, 16)));
  answer.uv[1][0] = sixteenths(d.integer(-2, 18));
  AnswerTerms terms;
  answer.has_uv = !d.coin();
  if (d.coin()) terms.space_tolerance = d.nudged(5 * size, 1);

  const bool abreast = *answer.toi - passing == std::clamp(answer.uv[1][0], 0.0, 1.0);
  Outcome expected = Outcome::kFalsePositive;
  if (terms.space_tolerance > 0 && !answer.has_uv) {
    expected = Outcome::kUnknown;
  } else if (abreast && terms.space_tolerance >= 5 * size) {
    expected = Outcome::kCorrect;
  }
  show(d, "has_uv", answer.has_uv);
  show(d, "u", answer.uv[1][0]);
  show(d, "space_tolerance", terms.space_tolerance);
  show(d, "case", asked);
  claim_judged(d, checked_or_unknown(asked), answer, expected, terms);

  // Bodies are judged by how far they are apart, wherever the hit says that they touch.
  double apart = 5 * size;
  for (MovingPatch<double>& body : asked.query.patches) {
    body.shape = Shape::hull(static_cast<int>(body.positions.size()));
    body.velocities.resize(1);
    body.radius = size * static_cast<double>(d.integer(0, 2));
    apart -= body.radius;
  }
  asked.truth.clearance = BodyClearance{exact(asked.query.t_max), {0, 3, 4}, true};
  asked.truth.proof = proof_word(*asked.truth.clearance);
  if (d.coin()) terms.space_tolerance = d.nudged(apart, 1);
  const bool may_be_near = terms.space_tolerance > 0 && terms.space_tolerance >= apart;
  show(d, "tolerance of bodies", terms.space_tolerance);
  show(d, "bodies", asked);
  claim_judged(d, checked_or_unknown(asked), answer,
               may_be_near ? Outcome::kUnknown : Outcome::kFalsePositive, terms);
}

/// A case about two points that meet once, which says what is false or has no proof. What is later
/// than the contact is mostly so by a ratio that halving finds, else certificates L take long to
/// refuse.
Case draw_unproven(Draw& choices) {
  const double contact = sixteenths(choices.integer(1, 16));
  const double size = std::ldexp(1.0, choices.integer(-40, 40));
  Case lie = points_that_meet(choices, contact, size);
  lie.query.t_max = sixteenths(choices.integer(0, 32));
  const Rational half = exact(contact / 2);
  const long k = choices.integer(1, 15);
  const bool is_halved = choices.choose(31) != 31;
  const Rational later =
      is_halved ? Rational(exact(contact) * 16 / k) : exact(contact + sixteenths(k));
  Truth& truth = lie.truth;
  truth = {};
  switch (choices.choose(5)) {
    case 0:
      truth.witness = Witness{choices.coin() ? later : half, {}};
      break;
    case 1:
      truth.clearance = MovingPlane{later, {}, 0};
      for (Rational& x : std::get<MovingPlane>(*truth.clearance).normal) {
        x = Rational(choices.integer(-2, 2));
      }
      break;
    case 2:  // the word of a method, which may be true
      truth.clear_until = later;
      break;
    case 3:
      truth.clearance = LinearClearance{later, choices.coin()};
      break;
    case 4:
      truth.clearance = LinearClearance{exact(contact), true};
      break;
    default:  // a proof of less than is said
      truth.clearance = LinearClearance{half, false};
      truth.clear_until = later;
  }
  const Rational end = exact(lie.query.t_max);
  if (truth.witness && truth.witness->t <= end) truth.collides = true;
  if (!truth.witness && end < later) {
    truth.collides = false;
    truth.proof = truth.clearance ? proof_word(*truth.clearance) : "rational-tdibm";
  }
  return lie;
}

void check_lie(Draw& d) {
  const Case lie = show(d, "case", draw_unproven(d));
  const CheckedCase known = checked_or_unknown(lie);
  claim_judged(d, known, Answer::miss(), Outcome::kUnknown);
  claim_judged(d, known, Answer::hit(0), Outcome::kUnknown);
}

constexpr std::array kToleranceKinds = {ToleranceKind::kTime, ToleranceKind::kTimeRelative,
                                        ToleranceKind::kSpace, ToleranceKind::kSpaceRelative};

bool is_looser(const AnswerTerms& a, const AnswerTerms& b) {
  return a.time_tolerance > b.time_tolerance || a.space_tolerance > b.space_tolerance ||
         a.depth_tolerance > b.depth_tolerance || a.early_tolerance > b.early_tolerance ||
         a.kept_separation < b.kept_separation;
}

void check_achieved(Draw& d) {
  PluginDescription claims;
  claims.conservative = d.coin();
  claims.tolerance_kind = d.pick(kToleranceKinds);
  claims.tolerance = sixteenths(d.integer(0, 16));
  if (d.coin()) claims.minimum_separation = sixteenths(d.integer(0, 16));
  PluginAnswer given;
  given.tolerance = d.pick(std::array{kNoNumber, HUGE_VAL, 1e300, claims.tolerance / 2,
                                      std::nextafter(claims.tolerance, HUGE_VAL)});
  const Query query = points_that_meet(d, 1, 1).query;
  const AnswerTerms claimed = terms_of(claims, {}, query);
  const AnswerTerms judged_by = terms_of(claims, given, query);
  PluginDescription tighter = claims;
  tighter.tolerance = std::min(claims.tolerance, given.tolerance);  // of NaN the claimed one
  const AnswerTerms wanted = terms_of(tighter, {}, query);
  const bool is_broken = claims.tolerance > 0 && given.tolerance > claims.tolerance;
  show(d, "claimed", claims.tolerance);
  show(d, "kind", claims.tolerance_kind);
  show(d, "achieved", given.tolerance);
  CLAIM(!is_looser(judged_by, claimed));
  CLAIM(!is_looser(judged_by, wanted));
  CLAIM(!is_looser(wanted, judged_by));
  CLAIM(broken_tolerance(claims, given).has_value() == is_broken);
}

void check_loosest_claims(Draw& d) {
  const ToleranceKind kind = d.pick(kToleranceKinds);
  const bool separates = d.coin();
  const bool relative =
      !separates && (kind == ToleranceKind::kTimeRelative || kind == ToleranceKind::kSpaceRelative);
  const double most = relative ? 1 : 0x1p40;
  const double claimed = d.pick(std::array{most, most / 2, std::nextafter(most, 0),
                                           std::nextafter(most, HUGE_VAL), 2 * most, 1e308});
  const std::string line =
      fmt::format(R"({{"protocol":1,"tolerance_kind":"{}","{}":{}}})", name_of(kind),
                  separates ? "minimum_separation" : "tolerance", claimed);
  show(d, "line", line);
  CLAIM(read_description(line).has_value() == (claimed <= most));
}

}  // namespace

std::vector<Property> judge_claims() {
  constexpr auto kSource = "src/case/judge.hpp";
  return {
      {"judge.goes_by_proven_times",
       "A miss is false, and a hit late, iff a contact is proven by then; a hit is false and a "
       "miss "
       "right iff absence is proven up to t_max, itself included; where nothing is proven they are "
       "unknown, and nonsense is an error",
       kSource, check_judge},
      {"judge.keeps_to_terms_of_time",
       "Ends of time, tolerances in time and a separation that is kept count as a method says, to "
       "the last bit; a late hit is no later than is said, nor than its time",
       kSource, check_terms_of_time},
      {"judge.keeps_to_terms_of_space",
       "A hit is false iff it is off by more than the tolerance in space, to the last bit; it is "
       "unknown where it does not say where, and of bodies that are no farther apart",
       kSource, check_terms_of_space},
      {"judge.believes_nothing_unproven",
       "By a false witness or plane, a certificate past a contact or of less than is said, or the "
       "word of a method, every answer is unknown",
       "src/certify/checker/check_case.hpp", check_lie},
      {"plugin.achieves_no_looser_tolerance",
       "An answer is judged by the tighter of the claimed and the achieved tolerance, and a looser "
       "one is a broken claim",
       "src/method/plugin/plugin_terms.hpp", check_achieved},
      {"plugin.claims_are_limited",
       "A tolerance or separation is accepted iff it is at most 2^40, or 1 where it is relative",
       "src/method/plugin/line_protocol.hpp", check_loosest_claims},
  };
}

}  // namespace ccdfuzz
