#include "report/histogram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace ccdfuzz {
namespace {

std::uint64_t total(const Histogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), std::uint64_t{0});
}

TEST(Histogram, LogarithmicBinsAreTenthsOfADecade) {
  const Histogram h = log_histogram({1e-3, 1.1e-3, 1e-2, 0, -1});
  EXPECT_TRUE(h.log);
  EXPECT_DOUBLE_EQ(h.lo, -3);
  EXPECT_DOUBLE_EQ(h.width, .1);
  EXPECT_EQ(h.counts.size(), 11U);
  EXPECT_EQ(h.counts.front(), 2U);
  EXPECT_EQ(h.counts.back(), 1U);
}

TEST(Histogram, LinearBinsHoldOutliersInTheLast) {
  std::vector<double> samples(99, 1);
  samples.push_back(1000);
  const Histogram h = linear_histogram(samples, .99);
  EXPECT_DOUBLE_EQ(h.width * static_cast<double>(h.counts.size()), 1);
  EXPECT_EQ(h.counts.back(), 100U);
  EXPECT_EQ(total(h), 100U);
}

TEST(Histogram, OfNothingIsEmpty) {
  EXPECT_TRUE(log_histogram({}).counts.empty());
  EXPECT_TRUE(log_histogram({0, -1}).counts.empty());
  EXPECT_TRUE(linear_histogram({}, 1).counts.empty());
  EXPECT_TRUE(linear_histogram({0, 0}, 1).counts.empty());
}

}  // namespace
}  // namespace ccdfuzz
