#include "query/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ccdfuzz {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Query until(double t_max) {
  Query query;
  for (auto& patch : query.patches) patch = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
  query.t_max = t_max;
  return query;
}

Truth contact(const Rational& t) {
  Truth truth;
  truth.collides = true;
  truth.witness = Witness{t, {}};
  return truth;
}
Truth no_contact() {
  Truth truth;
  truth.collides = false;
  truth.proof = "P";
  return truth;
}
Truth clear(const Rational& t) {
  Truth truth;
  truth.clear_until = t;
  return truth;
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

std::string judged(const Truth& truth, const Answer& answer, double t_max = 1,
                   const AnswerTerms& terms = {}) {
  return std::string(name_of(judge(until(t_max), truth, answer, terms)));
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
  Truth both = contact({1, 2});
  both.clear_until = Rational(1, 4);
  EXPECT_EQ(judged(both, hit(0.125)), "correct");
}

TEST(Judge, AMissIsAMissOnlyIfTheWitnessLiesInTheHorizon) {
  EXPECT_EQ(judged(contact({1, 2}), says(Verdict::kMiss)), "missed");
  EXPECT_EQ(judged(contact(1), says(Verdict::kMiss)), "missed");
  EXPECT_EQ(judged(contact(0), says(Verdict::kMiss), 0), "missed");
  Truth later = contact(1);
  EXPECT_EQ(judged(later, says(Verdict::kMiss), std::nextafter(1, 0)), "unknown");
  EXPECT_EQ(judged(later, hit(0.5), std::nextafter(1, 0)), "unknown");
  later.clear_until = Rational(1);
  EXPECT_EQ(judged(later, says(Verdict::kMiss), std::nextafter(1, 0)), "correct");
  EXPECT_EQ(judged(later, hit(0.5), std::nextafter(1, 0)), "false_positive");
}

TEST(Judge, AHitIsFalseOnlyWhereAbsenceIsProvenOnTheClosedHorizon) {
  EXPECT_EQ(judged(no_contact(), hit(0.5)), "false_positive");
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss)), "correct");
  EXPECT_EQ(judged(clear(1), hit(0.5)), "unknown");  // t = 1 itself may be a contact
  EXPECT_EQ(judged(clear(1), says(Verdict::kMiss)), "unknown");
  EXPECT_EQ(judged(clear(Rational("1001/1000")), hit(0.5)), "false_positive");
  EXPECT_EQ(judged(clear(Rational("1001/1000")), says(Verdict::kMiss)), "correct");
  EXPECT_EQ(judged(clear(0), says(Verdict::kMiss), 0), "unknown");
}

TEST(Judge, WithoutTruthNothingIsKnown) {
  EXPECT_EQ(judged({}, hit(0.5)), "unknown");
  EXPECT_EQ(judged({}, says(Verdict::kMiss)), "unknown");
  Truth claimed;  // a bare label proves nothing
  claimed.collides = true;
  EXPECT_EQ(judged(claimed, says(Verdict::kMiss)), "unknown");
}

TEST(Judge, UndecidedIsNeverWrong) {
  for (const Truth& truth : {contact(0), no_contact(), clear(1), Truth{}}) {
    EXPECT_EQ(judged(truth, says(Verdict::kUndecided)), "undecided");
    EXPECT_EQ(judged(truth, says(Verdict::kUndecided, 0.75)), "undecided");
  }
}

TEST(Judge, NonsenseIsAnErrorWhateverTheTruth) {
  for (const Truth& truth : {contact({1, 2}), no_contact(), clear(1), Truth{}}) {
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

TEST(Judge, WhatAMissSaysOfTimeIsNotLookedAt) {
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss, 0)), "correct");
  EXPECT_EQ(judged(no_contact(), says(Verdict::kMiss, kNan)), "correct");
}

Case asked(double t_max, const Truth& truth) {
  Case c;
  c.query = until(t_max);
  c.truth = truth;
  c.expect["tdibm"] = Outcome::kMissed;
  return c;
}

TEST(WithTMax, AbsenceHoldsForLessTimeButNotForMore) {
  EXPECT_EQ(with_t_max(asked(1, no_contact()), 0.5).truth.collides, false);
  EXPECT_EQ(with_t_max(asked(1, no_contact()), 1).truth.collides, false);
  const Case longer = with_t_max(asked(1, no_contact()), 1.5);
  EXPECT_EQ(longer.query.t_max, 1.5);
  EXPECT_EQ(longer.truth.collides, std::nullopt);
  EXPECT_EQ(judge(longer.query, longer.truth, hit(0.5)), Outcome::kUnknown);
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
  Query query = until(1);
  query.patches[0] = {Shape::point(), {{-1, 0, 0}}, {{2, 0, 0}}};
  query.patches[1] = {Shape::point(), {{0, 0.25, 0}}, {{0, 0, 0}}};
  AnswerTerms terms;
  terms.space_tolerance = 0.25;
  EXPECT_EQ(judge(query, no_contact(), hit(0.5), terms), Outcome::kCorrect);
  EXPECT_EQ(judge(query, no_contact(), hit(0.5 + 0x1p-40), terms), Outcome::kFalsePositive);
  terms.space_tolerance = std::nextafter(0.25, 0);
  EXPECT_EQ(judge(query, no_contact(), hit(0.5), terms), Outcome::kFalsePositive);
  terms.has_uv = false;
  EXPECT_EQ(judge(query, no_contact(), hit(0.5), terms), Outcome::kUnknown);
  // Parameters outside of the patch are no place on it.
  terms = {true, true, 0, 0.25, true};
  query.patches[1] = {Shape::curve(1), {{0, 0.25, 0}, {1, 0.25, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  Answer outside = hit(0.25);
  outside.uv[1] = {-0.5, 0};
  EXPECT_EQ(judge(query, no_contact(), outside, terms), Outcome::kFalsePositive);
}

}  // namespace
}  // namespace ccdfuzz
