// What the properties of the judge do not draw: properties/judge.cpp has the rest.
#include "case/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/checker/check_case.hpp"

namespace ccdfuzz {
namespace {

/// Two points that meet at a/b: their distance is |a − b·t|. A witness proves it.
Case meeting_at(const Rational& t, double t_max = 1) {
  Case made;
  made.query.patches = {
      MovingPatch<double>{
          Shape::point(), {{-t.get_num().get_d(), 0, 0}}, {{t.get_den().get_d(), 0, 0}}},
      MovingPatch<double>{Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}}};
  made.query.t_max = t_max;
  made.truth.witness = Witness{t, {}};
  if (t <= exact(t_max)) made.truth.collides = true;
  made.expect["tdibm"] = Outcome::kMissed;
  return made;
}

/// Two points that stay 1/4 apart.
Case staying_apart() {
  Case made;
  made.query.patches = {MovingPatch<double>{Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}},
                        MovingPatch<double>{Shape::point(), {{0, 0.25, 0}}, {{0, 0, 0}}}};
  made.truth.collides = false;
  made.truth.proof = "L";
  made.truth.clearance = LinearClearance{1, true};
  return made;
}

TEST(Judge, AContactBetweenDoublesIsComparedExactly) {
  const CheckedCase third = *check_case(meeting_at({1, 3}));
  EXPECT_EQ(judge(third, Answer::hit(1.0 / 3)), Outcome::kCorrect);
  EXPECT_EQ(judge(third, Answer::hit(std::nextafter(1.0 / 3, 1))), Outcome::kLate);
}

TEST(Judge, IgnoresTheTimeOfAMiss) {
  const CheckedCase apart = *check_case(staying_apart());
  for (const double toi : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    Answer miss = Answer::miss();
    miss.toi = toi;
    EXPECT_EQ(judge(apart, miss), Outcome::kCorrect) << toi;
  }
}

TEST(Judge, NothingIsJudgedByAFalseRoot) {
  Case lie = staying_apart();
  lie.truth = {};
  lie.truth.collides = true;
  lie.truth.contact_root = ContactRoot{{-1, 2}, 0, 1};
  EXPECT_FALSE(check_case(lie));
  EXPECT_EQ(judge(checked_or_unknown(lie), Answer::miss()), Outcome::kUnknown);
}

TEST(WithTMax, AbsenceHoldsForLessTimeAndAContactFromItsTimeOn) {
  EXPECT_EQ(with_t_max(staying_apart(), 0.5).truth.collides, false);
  EXPECT_EQ(with_t_max(staying_apart(), 1).truth.collides, false);
  EXPECT_EQ(with_t_max(staying_apart(), 1.5).truth.collides, std::nullopt);
  EXPECT_EQ(with_t_max(meeting_at(1), 1.5).truth.collides, true);
  const Case shorter = with_t_max(meeting_at(1), 0.5);
  EXPECT_EQ(shorter.truth.collides, std::nullopt);
  EXPECT_TRUE(shorter.truth.witness);
  EXPECT_EQ(with_t_max(shorter, 1).truth.collides, true);
  EXPECT_TRUE(shorter.expect.empty()) << "expectations are of the old query";
}

TEST(JudgeByTerms, ParametersOutsideOfATriangleAreMovedToItsEdge) {
  Case passing = staying_apart();
  Query& query = passing.query;
  query.patches[0] = {Shape::point(), {{-1, 0, 0}}, {{2, 0, 0}}};
  query.patches[1] = {
      Shape::triangle(1), {{0, 0.25, 0}, {1, 0.25, 0}, {0, 0.25, 1}}, Points<double>(3, {0, 0, 0})};
  AnswerTerms terms;
  terms.space_tolerance = 0.25;
  Answer outside = Answer::hit(1);
  outside.uv[1] = {0, std::nextafter(1, 2)};
  EXPECT_EQ(judge(checked_or_unknown(passing), outside, terms), Outcome::kCorrect);
}

}  // namespace
}  // namespace ccdfuzz
