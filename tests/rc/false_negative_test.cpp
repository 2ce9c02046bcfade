// Which answers let a known contact through.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "generators/contact.hpp"

namespace ccdfuzz {
namespace {

Answer with(Verdict verdict) {
  Answer answer;
  answer.verdict = verdict;
  return answer;
}

TEST(FalseNegative, IsAMissOrALateHit) {
  const Contact contact = falling_point();  // at t = 1 = t_max
  EXPECT_TRUE(is_false_negative(contact, Answer::miss()));
  EXPECT_TRUE(is_false_negative(contact, Answer::hit(std::nextafter(1.0, 2.0))));
  EXPECT_FALSE(is_false_negative(contact, Answer::hit(1)));
  EXPECT_FALSE(is_false_negative(contact, Answer::hit(0)));
}

TEST(FalseNegative, IsAHitAtNoTime) {
  const Contact contact = falling_point();
  EXPECT_TRUE(is_false_negative(contact, Answer::hit(std::nan(""))));
  EXPECT_TRUE(is_false_negative(contact, Answer::hit(HUGE_VAL)));
  EXPECT_TRUE(is_false_negative(contact, Answer::hit(-HUGE_VAL)));
  EXPECT_TRUE(is_false_negative(contact, with(Verdict::kHit)));
}

TEST(FalseNegative, IsAHitOutsideOfTheStep) {
  AnswerTerms terms;
  terms.time_tolerance = 0.25;
  EXPECT_TRUE(is_false_negative(falling_point(), Answer::hit(-1)));
  EXPECT_TRUE(is_false_negative(falling_point(), Answer::hit(-0x1p-1074)));
  EXPECT_FALSE(is_false_negative(falling_point(), Answer::hit(-0.0)));
  EXPECT_TRUE(is_false_negative(falling_point(), Answer::hit(1.125), terms));
}

TEST(FalseNegative, IsNothingThatDoesNotAnswer) {
  EXPECT_FALSE(is_false_negative(falling_point(), with(Verdict::kUndecided)));
  EXPECT_FALSE(is_false_negative(falling_point(), with(Verdict::kRefused)));
}

TEST(FalseNegative, FollowsTheTerms) {
  Contact contact = falling_point();
  contact.query.t_max = 2;
  AnswerTerms terms;
  terms.time_tolerance = 0.25;
  EXPECT_FALSE(is_false_negative(contact, Answer::hit(1.25), terms));
  EXPECT_TRUE(is_false_negative(contact, Answer::hit(std::nextafter(1.25, 2)), terms));
  contact.query.t_max = 1;
  terms.closed_t_max = false;
  EXPECT_FALSE(is_false_negative(contact, Answer::miss(), terms));
  contact.query.t_max = 2;
  EXPECT_TRUE(is_false_negative(contact, Answer::miss(), terms));
  contact.t = Dyadic(0);
  EXPECT_TRUE(is_false_negative(contact, Answer::miss(), terms));
  terms.contact_at_zero = false;
  EXPECT_FALSE(is_false_negative(contact, Answer::miss(), terms));
}

}  // namespace
}  // namespace ccdfuzz
