#include "eval/tally.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace ccdfuzz {
namespace {

Answer answer_of(Verdict verdict, std::uint64_t pops, double seconds) {
  Answer answer;
  answer.verdict = verdict;
  answer.pops = pops;
  answer.seconds = seconds;
  return answer;
}

TEST(Tally, CountsEachOutcomeOnceAndBothKindsOfFalseNegative) {
  Tally tally;
  tally.add(answer_of(Verdict::kMiss, 3, 0.5), Outcome::kMissed, true);
  tally.add(answer_of(Verdict::kHit, 4, 0.25), Outcome::kLate, true);
  tally.add(answer_of(Verdict::kHit, 5, 0.25), Outcome::kFalsePositive, false);
  tally.add(answer_of(Verdict::kUndecided, 8, 1), Outcome::kUndecided, std::nullopt);
  EXPECT_EQ(tally.n, 4U);
  EXPECT_EQ(tally.positives, 2U);
  EXPECT_EQ(tally.negatives, 1U);
  EXPECT_EQ(tally.false_negatives(), 2U);
  for (const Outcome o :
       {Outcome::kMissed, Outcome::kLate, Outcome::kFalsePositive, Outcome::kUndecided}) {
    EXPECT_EQ(tally.count(o), 1U) << name_of(o);
  }
  EXPECT_EQ(tally.count(Outcome::kCorrect), 0U);
  EXPECT_EQ(tally.pops, 20U);
  EXPECT_EQ(tally.mean_seconds(), 0.5);
}

TEST(Tally, UndecidedIsNeitherFalseNegativeNorFalsePositive) {
  Tally tally;
  tally.add(answer_of(Verdict::kUndecided, 1, 0), Outcome::kUndecided, true);
  tally.add(answer_of(Verdict::kUndecided, 1, 0), Outcome::kUndecided, false);
  EXPECT_EQ(tally.false_negatives(), 0U);
  EXPECT_EQ(tally.count(Outcome::kFalsePositive), 0U);
}

TEST(Tally, WhatIsNotAskedIsInNoOtherNumber) {
  Tally asked, tally;
  asked.add(answer_of(Verdict::kMiss, 3, 0.5), Outcome::kCorrect, false);
  tally = asked;
  for (const std::optional<bool>& collides : {std::optional<bool>(), {true}, {false}}) {
    tally.add(answer_of(Verdict::kRefused, 7, 1), Outcome::kNotAsked, collides);
  }
  EXPECT_EQ(tally.not_asked(), 3U);
  EXPECT_EQ(tally.n, asked.n);
  EXPECT_EQ(tally.positives, asked.positives);
  EXPECT_EQ(tally.negatives, asked.negatives);
  EXPECT_EQ(tally.pops, asked.pops);
  EXPECT_EQ(tally.mean_seconds(), asked.mean_seconds());
}

TEST(Tally, MergingPartsEqualsAddingAll) {
  Tally all, left, right;
  for (size_t i = 0; i < 21; ++i) {
    const Outcome outcome = kAllOutcomes[i % kAllOutcomes.size()];
    const Answer answer = answer_of(Verdict::kHit, i, static_cast<double>(i));
    all.add(answer, outcome, i % 2 == 0);
    (i % 3 == 0 ? left : right).add(answer, outcome, i % 2 == 0);
  }
  left.merge(right);
  EXPECT_EQ(left.n, all.n);
  EXPECT_EQ(left.positives, all.positives);
  EXPECT_EQ(left.negatives, all.negatives);
  EXPECT_EQ(left.by_outcome, all.by_outcome);
  EXPECT_EQ(left.pops, all.pops);
  EXPECT_EQ(left.seconds, all.seconds);  // small integers: exact in any order
}

TEST(Tally, AnEmptyOneHasMeanZero) {
  EXPECT_EQ(Tally().mean_seconds(), 0);
  EXPECT_EQ(Timings().median(), 0);
  EXPECT_EQ(Timings().p99(), 0);
}

TEST(Timings, QuantilesAreNearestRanks) {
  Timings timings;
  // 1..100 in an order that is neither rising nor falling.
  for (int i = 0; i < 100; ++i) timings.add((i * 37) % 100 + 1);
  EXPECT_EQ(timings.median(), 50);
  EXPECT_EQ(timings.p99(), 99);
  EXPECT_EQ(timings.quantile(1), 100);
  EXPECT_EQ(timings.quantile(0.001), 1);
}

TEST(Timings, AQuantileOfOneSampleIsThatSample) {
  Timings timings;
  timings.add(7);
  EXPECT_EQ(timings.median(), 7);
  EXPECT_EQ(timings.p99(), 7);
}

TEST(Timings, AMedianOfTwoIsTheLower) {
  Timings timings;
  timings.add(2);
  timings.add(1);
  EXPECT_EQ(timings.median(), 1);
  EXPECT_EQ(timings.p99(), 2);
}

}  // namespace
}  // namespace ccdfuzz
