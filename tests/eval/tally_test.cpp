#include "eval/tally.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ccdfuzz {
namespace {

Answer answer_of(Verdict verdict, std::uint64_t pops, double seconds) {
  Answer answer;
  answer.verdict = verdict;
  answer.pops = pops;
  answer.seconds = seconds;
  return answer;
}

TEST(Tally, CountsEachOutcomeOnce) {
  Tally tally;
  tally.add(answer_of(Verdict::kMiss, 3, 0.5), Outcome::kMissed, true);
  tally.add(answer_of(Verdict::kHit, 4, 0.25), Outcome::kLate, true);
  tally.add(answer_of(Verdict::kHit, 5, 0.25), Outcome::kFalsePositive, false);
  tally.add(answer_of(Verdict::kUndecided, 8, 1), Outcome::kUndecided, std::nullopt);
  EXPECT_EQ(tally.n, 4U);
  EXPECT_EQ(tally.positives, 2U);
  EXPECT_EQ(tally.negatives, 1U);
  for (const Outcome o :
       {Outcome::kMissed, Outcome::kLate, Outcome::kFalsePositive, Outcome::kUndecided}) {
    EXPECT_EQ(tally.count(o), 1U) << name_of(o);
  }
  EXPECT_EQ(tally.count(Outcome::kCorrect), 0U);
  EXPECT_EQ(tally.pops, 20U);
  EXPECT_TRUE(std::isinf(tally.late_by)) << "nothing said how late";
  EXPECT_EQ(tally.seconds.mean(), 0.5);
}

TEST(Tally, CountsQueriesThatWereNotAskedInNoOtherNumber) {
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
  EXPECT_EQ(tally.seconds, asked.seconds);
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
  left.merge(Tally());
  EXPECT_EQ(left.n, all.n);
  EXPECT_EQ(left.positives, all.positives);
  EXPECT_EQ(left.negatives, all.negatives);
  EXPECT_EQ(left.by_outcome, all.by_outcome);
  EXPECT_EQ(left.pops, all.pops);
  EXPECT_EQ(left.seconds, all.seconds);  // small integers: exact in any order
}

TEST(Tally, AnEmptyOneHasMeanZero) {
  EXPECT_EQ(Tally().seconds.mean(), 0);
  EXPECT_EQ(LogHistogram().median(), 0);
  EXPECT_EQ(LogHistogram().p99(), 0);
}

/// A bin is 2^(1/32) wide, and its middle, to four digits, is half of that from its samples.
constexpr double kHalfBin = 0.0116;

TEST(LogHistogram, QuantilesAreNearestRanksToHalfABin) {
  LogHistogram samples;
  std::vector<double> all;
  // Eleven decades, in an order that is neither rising nor falling.
  for (int i = 0; i < 1000; ++i) {
    all.push_back(std::pow(10.0, 0.011 * ((i * 371) % 1000) - 7));
    samples.add(all.back());
  }
  std::ranges::sort(all);
  for (const double q : {0.001, 0.25, 0.5, 0.9, 0.99, 1.0}) {
    const double exact = all[static_cast<size_t>(std::ceil(q * 1000)) - 1];
    EXPECT_NEAR(samples.quantile(q) / exact, 1, kHalfBin) << q;
  }
  EXPECT_EQ(samples.largest(), all.back());
  EXPECT_LT(samples.bins().size(), 11 * 3.33 * 32 + 2);
}

TEST(LogHistogram, AQuantileOfOneSampleIsThatSample) {
  LogHistogram samples;
  samples.add(7);
  EXPECT_EQ(samples.median(), 7);
  EXPECT_EQ(samples.p99(), 7);
}

TEST(LogHistogram, AMedianOfTwoIsTheLower) {
  LogHistogram samples;
  samples.add(2);
  samples.add(1);
  EXPECT_NEAR(samples.median(), 1, kHalfBin);
  EXPECT_EQ(samples.p99(), 2);
}

TEST(LogHistogram, CountsNumbersThatAreNotPositiveAsZero) {
  LogHistogram samples;
  for (const double x : {0.0, -1.0, std::nan(""), 3.0}) samples.add(x);
  EXPECT_EQ(samples.count(), 4U);
  EXPECT_EQ(samples.median(), 0);
  EXPECT_EQ(samples.p99(), 3);
  EXPECT_EQ(samples.sum(), 3);
}

}  // namespace
}  // namespace ccdfuzz
