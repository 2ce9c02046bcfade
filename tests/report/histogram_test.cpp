#include "report/histogram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace ccdfuzz {
namespace {

LogHistogram of(const std::vector<double>& samples) {
  LogHistogram histogram;
  for (const double x : samples) histogram.add(x);
  return histogram;
}

std::uint64_t total(const Histogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0});
}

TEST(Histogram, LogarithmicBinsAreQuartersOfAnOctave) {
  const Histogram h = log_bins(of({0.25, 0.26, 4, 0, -1}));
  EXPECT_DOUBLE_EQ(h.lo, std::log10(0.25));
  EXPECT_DOUBLE_EQ(h.width, std::log10(2) / 4);
  EXPECT_EQ(h.counts.size(), 17U);
  EXPECT_EQ(h.counts.front(), 2U);
  EXPECT_EQ(h.counts.back(), 1U);
}

TEST(Histogram, LinearBinsHoldOutliersInTheLastAndZerosInTheFirst) {
  std::vector<double> samples(98, 1);
  samples.insert(samples.end(), {1000, 0});
  const Histogram h = linear_bins(of(samples), .99);
  EXPECT_NEAR(h.width * static_cast<double>(h.counts.size()), 1, 0.02);
  EXPECT_EQ(h.counts.front(), 1U);
  EXPECT_EQ(h.counts.back(), 99U);
  EXPECT_EQ(total(h), 100U);
}

TEST(Histogram, IsEmptyWithoutValues) {
  EXPECT_TRUE(log_bins(of({})).counts.empty());
  EXPECT_TRUE(log_bins(of({0, -1})).counts.empty());
  EXPECT_TRUE(linear_bins(of({}), 1).counts.empty());
  EXPECT_TRUE(linear_bins(of({0, 0}), 1).counts.empty());
}

}  // namespace
}  // namespace ccdfuzz
