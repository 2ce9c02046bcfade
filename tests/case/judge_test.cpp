#include "case/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/checker/check_case.hpp"

namespace ccdfuzz {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What is so of two points.
struct Scene {
  std::optional<Rational> meet;  ///< when; they part again
  bool proven = true;            ///< by a witness
  /// No contact before, by a certificate.
  std::optional<Rational> clear;
};

Scene contact(const Rational& t) {
  return {t, true, std::nullopt};
}
Scene no_contact() {
  return {};
}
/// They do meet then, but only that they do not before is known.
Scene clear(const Rational& t) {
  return {t, false, t};
}
/// Nothing is known.
Scene unknown() {
  return {Rational(1, 2), false, std::nullopt};
}

/// Points that meet at t = a/b have the distance |a − b·t| at t; others stay 1/4 apart.
Case case_of(const Scene& scene, double t_max) {
  Case made;
  Query& query = made.query;
  for (auto& patch : query.patches) patch = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  query.t_max = t_max;
  Truth& truth = made.truth;
  if (!scene.meet) {
    query.patches[1].positions[0] = {0, 0.25, 0};
    truth.collides = false;
    truth.proof = "L";
    truth.clearance = LinearClearance{exact(t_max), true};
    return made;
  }
  query.patches[0].positions[0] = {-scene.meet->get_num().get_d(), 0, 0};
  query.patches[0].velocities[0] = {scene.meet->get_den().get_d(), 0, 0};
  if (scene.proven) {
    truth.witness = Witness{*scene.meet, {}};
    if (*scene.meet <= exact(t_max)) truth.collides = true;
  }
  if (scene.clear) {
    truth.clear_until = *scene.clear;
    truth.clearance = LinearClearance{*scene.clear, false};
  }
  return made;
}

CheckedCase known(const Scene& scene, double t_max) {
  auto checked = check_case(case_of(scene, t_max));
  if (!checked) throw std::runtime_error(checked.error().message());
  return *checked;
}

Answer hit(std::optional<double> toi) {
  Answer answer;
  answer.verdict = Verdict::kHit;
  answer.toi = toi;
  return answer;
}
Answer says(Verdict verdict, std::optional<double> toi = std::nullopt) {
  Answer answer;
  answer.verdict = verdict;
  answer.toi = toi;
  return answer;
}

std::string judged(const Scene& scene, const Answer& answer, double t_max = 1,
                   const AnswerTerms& terms = {}) {
  return std::string(name_of(judge(known(scene, t_max), answer, terms)));
}

TEST(Judge, AHitIsRightUpToTheProvenContactAndLateFromThereOn) {
  EXPECT_EQ(judged(contact({1, 2}), hit(0.5)), "correct");
  EXPECT_EQ(judged(contact({1, 2}), hit(std::nextafter(0.5, 1))), "late");
  EXPECT_EQ(judged(contact({1, 2}), hit(0)), "correct");
  EXPECT_EQ(judged(contact({1, 2}), hit(1)), "late");
  // The double next to 1/3 from below is early, the next one late.
  EXPECT_EQ(judged(contact({1, 3}), hit(1.0 / 3)), "correct");
  EXPECT_EQ(judged(contact({1, 3}), hit(std::nextafter(1.0 / 3, 1))), "late");
  EXPECT_EQ(judged(contact(0), hit(-0.0)), "correct");
  EXPECT_EQ(judged(contact(0), hit(0x1p-1074)), "late");
  // Earlier than what is proven clear is a matter of quality, not of soundness.
  Scene both = contact({1, 2});
  both.clear = Rational(1, 4);
  EXPECT_EQ(judged(both, hit(0.125)), "correct");
}

TEST(Judge, AMissIsAMissOnlyIfTheWitnessLiesInTheHorizon) {
  EXPECT_EQ(judged(contact({1, 2}), says(Verdict::kMiss)), "missed");
  EXPECT_EQ(judged(contact(1), says(Verdict::kMiss)), "missed");
  EXPECT_EQ(judged(contact(0), says(Verdict::kMiss), 0), "missed");
  Scene later = contact(1);
  EXPECT_EQ(judged(later, says(Verdict::kMiss), std::nextafter(1, 0)), "unknown");
  EXPECT_EQ(judged(later, hit(0.5), std::nextafter(1, 0)), "unknown");
  later.clear = Rational(1);
  EXPECT_EQ(judged(later, says(Verdict::kMiss), std::nextafter(1, 0)), "correct");
  EXPECT_EQ(judged(later, hit(0.5), std::nextafter(1, 0)), "false_positive");
}

TEST(Judge, AHitIsFalseOnlyWhereAbsenceIsProvenOnTheClosedHorizon) {
  EXPECT_EQ(judged(no_contact(), hit(0.5)), "false_positive");
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss)), "correct");
  EXPECT_EQ(judged(clear(1), hit(0.5)), "unknown");  // t = 1 itself may be a contact
  EXPECT_EQ(judged(clear(1), says(Verdict::kMiss)), "unknown");
  EXPECT_EQ(judged(clear(Rational(1001, 1000)), hit(0.5)), "false_positive");
  EXPECT_EQ(judged(clear(Rational(1001, 1000)), says(Verdict::kMiss)), "correct");
  EXPECT_EQ(judged(clear(0), says(Verdict::kMiss), 0), "unknown");
}

TEST(Judge, KnowsNothingWithoutProof) {
  EXPECT_EQ(judged(unknown(), hit(0.5)), "unknown");
  EXPECT_EQ(judged(unknown(), says(Verdict::kMiss)), "unknown");
  EXPECT_EQ(judge({}, says(Verdict::kMiss)), Outcome::kUnknown);
  // A bare label, or the word of a method, true as it is.
  Case claimed = case_of(no_contact(), 1);
  claimed.truth.clearance.reset();
  claimed.truth.proof = "rational-tdibm";
  claimed.truth.clear_until = 2;
  const auto by_word = check_case(claimed);
  ASSERT_TRUE(by_word);
  EXPECT_EQ(by_word->collides(), std::nullopt);
  EXPECT_EQ(judge(*by_word, hit(0.5)), Outcome::kUnknown);
  EXPECT_EQ(judge(*by_word, says(Verdict::kMiss)), Outcome::kUnknown);
}

/// What the checker refuses is no case to judge by, and where it is judged all the same, unknown.
TEST(Judge, NothingIsJudgedByAFalseProof) {
  const auto expect_nothing = [](Case lie, const char* what) {
    EXPECT_FALSE(check_case(lie)) << what;
    for (const Answer& answer : {hit(0.25), says(Verdict::kMiss)}) {
      EXPECT_EQ(judge(checked_or_unknown(lie), answer), Outcome::kUnknown) << what;
    }
  };
  Case lie = case_of(unknown(), 1);  // they do touch, at 1/2
  lie.truth.collides = false;
  lie.truth.proof = "L";
  lie.truth.clearance = LinearClearance{Rational(1), true};
  expect_nothing(lie, "absence");
  lie.truth.clearance = MovingPlane{Rational(2), {1, 0, 0}, 0};
  lie.truth.proof = "P";
  expect_nothing(lie, "a plane");
  lie = case_of(unknown(), 0.25);
  lie.truth.clear_until = 1;
  lie.truth.clearance = LinearClearance{Rational(1, 2), false};
  expect_nothing(lie, "clear_until past the certificate");
  lie = case_of(no_contact(), 1);
  lie.truth = {};
  lie.truth.collides = true;
  lie.truth.witness = Witness{Rational(1, 2), {}};
  expect_nothing(lie, "a witness");
  lie.truth.witness.reset();
  lie.truth.contact_root = ContactRoot{{-1, 2}, 0, 1};
  expect_nothing(lie, "a root");
}

TEST(Judge, UndecidedIsNeverWrong) {
  for (const Scene& truth : {contact(0), no_contact(), clear(1), unknown()}) {
    EXPECT_EQ(judged(truth, says(Verdict::kUndecided)), "undecided");
    EXPECT_EQ(judged(truth, says(Verdict::kUndecided, 0.75)), "undecided");
  }
}

TEST(Judge, ARefusalIsNotAskedWhateverItHolds) {
  for (const Scene& truth : {contact(0), no_contact(), clear(1), unknown()}) {
    EXPECT_EQ(judged(truth, says(Verdict::kRefused)), "not_asked");
    EXPECT_EQ(judged(truth, says(Verdict::kRefused, kNan)), "not_asked");
  }
}

TEST(Judge, NonsenseIsAnErrorWhateverTheTruth) {
  for (const Scene& truth : {contact({1, 2}), no_contact(), clear(1), unknown()}) {
    EXPECT_EQ(judged(truth, hit(std::nullopt)), "error");
    EXPECT_EQ(judged(truth, hit(kNan)), "error");
    EXPECT_EQ(judged(truth, hit(kInfinity)), "error");
    EXPECT_EQ(judged(truth, hit(-0x1p-1074)), "error");
    EXPECT_EQ(judged(truth, hit(std::nextafter(1, 2))), "error");
    EXPECT_EQ(judged(truth, says(Verdict::kUndecided, kNan)), "error");
    Answer nowhere = hit(0.25);
    nowhere.uv[1][1] = kNan;
    EXPECT_EQ(judged(truth, nowhere), "error");
  }
}

TEST(Judge, IgnoresTheTimeOfAMiss) {
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss, 0)), "correct");
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss, kNan)), "correct");
}

Case asked(double t_max, const Scene& scene) {
  Case c = case_of(scene, t_max);
  c.expect["tdibm"] = Outcome::kMissed;
  return c;
}

TEST(WithTMax, AbsenceHoldsForLessTimeButNotForMore) {
  EXPECT_EQ(with_t_max(asked(1, no_contact()), 0.5).truth.collides, false);
  EXPECT_EQ(with_t_max(asked(1, no_contact()), 1).truth.collides, false);
  const Case longer = with_t_max(asked(1, no_contact()), 1.5);
  EXPECT_EQ(longer.query.t_max, 1.5);
  EXPECT_EQ(longer.truth.collides, std::nullopt);
  const CheckedCase checked = known(no_contact(), 1).with_t_max(1.5);
  EXPECT_EQ(checked.value().truth.collides, std::nullopt);
  EXPECT_EQ(judge(checked, hit(0.5)), Outcome::kUnknown);
  EXPECT_EQ(judge(checked.with_t_max(0.5), hit(0.5)), Outcome::kFalsePositive);
}

TEST(WithTMax, AWitnessProvesAContactFromItsTimeOn) {
  EXPECT_EQ(with_t_max(asked(1, contact(1)), 1.5).truth.collides, true);
  const Case shorter = with_t_max(asked(1, contact(1)), 0.5);
  EXPECT_EQ(shorter.truth.collides, std::nullopt);
  EXPECT_TRUE(shorter.truth.witness);
  EXPECT_EQ(with_t_max(shorter, 1).truth.collides, true);
}

TEST(WithTMax, ExpectationsAreOfTheOldQuery) {
  EXPECT_TRUE(with_t_max(asked(1, contact(1)), 1.5).expect.empty());
}

TEST(JudgeByTerms, AnEndOfTimeThatIsLeftOutBindsNot) {
  AnswerTerms open;
  open.closed_t_max = false;
  EXPECT_EQ(judged(contact(1), says(Verdict::kMiss), 1, open), "unknown");
  EXPECT_EQ(judged(contact(1), says(Verdict::kMiss), 2, open), "missed");
  AnswerTerms no_start;
  no_start.contact_at_zero = false;
  EXPECT_EQ(judged(contact(0), says(Verdict::kMiss), 1, no_start), "unknown");
  EXPECT_EQ(judged(contact(0), hit(0.5), 1, no_start), "unknown");
  EXPECT_EQ(judged(contact({1, 2}), says(Verdict::kMiss), 1, no_start), "missed");
}

TEST(JudgeByTerms, ATimeToleranceIsExact) {
  AnswerTerms terms;
  terms.time_tolerance = 0.25;
  EXPECT_EQ(judged(contact({1, 2}), hit(0.75), 1, terms), "correct");
  EXPECT_EQ(judged(contact({1, 2}), hit(std::nextafter(0.75, 1)), 1, terms), "late");
  EXPECT_EQ(judged(contact({1, 2}), says(Verdict::kMiss), 1, terms), "missed");
  EXPECT_EQ(judged(no_contact(), hit(0.5), 1, terms), "false_positive");
}

TEST(JudgeByTerms, AHitWithinItsToleranceInSpaceIsNotFalse) {
  // Two points that pass each other at the distance 1/4, at t = 1/2.
  Case passing = case_of(no_contact(), 1);
  Query& query = passing.query;
  query.patches[0] = {Shape::point(), {{-1, 0, 0}}, {{2, 0, 0}}};
  query.patches[1] = {Shape::point(), {{0, 0.25, 0}}, {{0, 0, 0}}};
  AnswerTerms terms;
  terms.space_tolerance = 0.25;
  EXPECT_EQ(judge(checked_or_unknown(passing), hit(0.5), terms), Outcome::kCorrect);
  EXPECT_EQ(judge(checked_or_unknown(passing), hit(0.5 + 0x1p-40), terms), Outcome::kFalsePositive);
  terms.space_tolerance = std::nextafter(0.25, 0);
  EXPECT_EQ(judge(checked_or_unknown(passing), hit(0.5), terms), Outcome::kFalsePositive);
  Answer somewhere = hit(0.5);
  somewhere.has_uv = false;
  EXPECT_EQ(judge(checked_or_unknown(passing), somewhere, terms), Outcome::kUnknown);
  // Parameters outside of the patch are moved to its edge: the answer may only have rounded them.
  terms = {true, true, 0, 0.25, true};
  query.patches[1] = {Shape::curve(1), {{0, 0.25, 0}, {1, 0.25, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  Answer outside = hit(0.25);
  outside.uv[1] = {-0.5, 0};
  EXPECT_EQ(judge(checked_or_unknown(passing), outside, terms), Outcome::kFalsePositive);
  outside.toi = 0.5;
  EXPECT_EQ(judge(checked_or_unknown(passing), outside, terms), Outcome::kCorrect);
  query.patches[1] = {
      Shape::triangle(1), {{0, 0.25, 0}, {1, 0.25, 0}, {0, 0.25, 1}}, Points<double>(3, {0, 0, 0})};
  outside.uv[1] = {0, std::nextafter(1, 2)};
  outside.toi = 1;
  EXPECT_EQ(judge(checked_or_unknown(passing), outside, terms), Outcome::kCorrect);
}

}  // namespace
}  // namespace ccdfuzz
