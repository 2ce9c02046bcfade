// Which answers let a known contact through.
#include <gtest/gtest.h>

#include <cmath>

#include "generators/contact.hpp"
#include "generators/generate.hpp"

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

TEST(FalseNegative, IsAHitAtNoTimeOfTheStep) {
  AnswerTerms terms;
  terms.time_tolerance = 0.25;
  for (const double at : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0, -0x1p-1074}) {
    EXPECT_TRUE(is_false_negative(falling_point(), Answer::hit(at))) << at;
  }
  EXPECT_TRUE(is_false_negative(falling_point(), with(Verdict::kHit)));
  EXPECT_FALSE(is_false_negative(falling_point(), Answer::hit(-0.0)));
  EXPECT_TRUE(is_false_negative(falling_point(), Answer::hit(1.125), terms));
}

TEST(FalseNegative, RefusesTermsThatAreNone) {
  EXPECT_THROW(is_false_negative(falling_point(), Answer::miss(), {.time_tolerance = -1}),
               std::invalid_argument);
  EXPECT_THROW(is_wrong(case_of(falling_point()), {}, {.space_tolerance = std::nan("")}),
               std::invalid_argument);
}

TEST(FalseNegative, IsNothingThatDoesNotAnswer) {
  EXPECT_FALSE(is_false_negative(falling_point(), with(Verdict::kUndecided)));
  EXPECT_FALSE(is_false_negative(falling_point(), with(Verdict::kRefused)));
}

TEST(FalseNegative, SaysWhatWasAnsweredAndWhenTheyTouch) {
  Contact contact = falling_point();
  contact.t = Dyadic(Integer(3), -2);
  EXPECT_EQ(is_false_negative(contact, Answer::miss()).why,
            "answered miss; they touch at t = 0.75 (0x1.8p-1)");
  contact.t += Dyadic(Integer(1), -60);
  EXPECT_EQ((!is_false_negative(contact, Answer::hit(1), {.time_tolerance = 0.125})).why,
            "answered hit at 1 (0x1p+0); they touch at t = 0.75 (0x1.8p-1) to 0.7500000000000001 "
            "(0x1.8000000000001p-1); a hit may be 0.125 later");
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

TEST(Wrong, IsOfAnyCaseWhatItsProofSays) {
  GeneratorOptions options{.contact = ContactClass::kVF, .family = Family::kSeparated};
  Case known = generate(options, 0).value;
  ASSERT_GT(known.query.separation, 0);
  EXPECT_FALSE(is_wrong(known, Answer::hit(0)));
  const Explained missed = is_wrong(known, Answer::miss());
  EXPECT_TRUE(missed && missed.why.starts_with("missed: answered miss; contact by t = ")) << missed;
  options.kind = CaseKind::kRN;
  const Case clear = generate(options, 0).value;
  EXPECT_FALSE(is_wrong(clear, Answer::miss()));
  EXPECT_EQ(is_wrong(clear, Answer::hit(0)).why,
            "false_positive: answered hit at 0 (0x0p+0); no contact in [0, t_max]");
  known.truth.witness->t /= 2;  // which does not hold
  EXPECT_FALSE(is_wrong(known, Answer::miss()));
}

}  // namespace
}  // namespace ccdfuzz
