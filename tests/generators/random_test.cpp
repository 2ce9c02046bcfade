#include "generators/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace ccdfuzz {
namespace {

// The values are those of the published SplitMix64 started at 0.
TEST(Random, IsSplitMix64) {
  Random random(0);
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafu);
  EXPECT_EQ(random.next(), 0x6e789e6aa1b965f4u);
  EXPECT_EQ(random.next(), 0x06c45d188009454fu);
}

TEST(Random, BelowHitsEveryValueAboutEquallyOftenAndNoOther) {
  for (const std::uint64_t bound : {1u, 2u, 3u, 6u, 17u}) {
    Random random(bound);
    std::vector<int> count(bound);
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) ++count.at(random.below(bound));
    // Six standard deviations of a binomial count, whose variance is below its mean.
    const double mean = static_cast<double>(kDraws) / static_cast<double>(bound);
    for (const int c : count) EXPECT_NEAR(c, mean, 6 * std::sqrt(mean)) << "bound " << bound;
  }
}

TEST(Random, BetweenReachesBothEnds) {
  Random random(1);
  std::set<std::int64_t> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(random.between(-3, 4));
  EXPECT_EQ(seen, (std::set<std::int64_t>{-3, -2, -1, 0, 1, 2, 3, 4}));
}

TEST(Random, DyadicStaysInItsRangeAndOnItsGrid) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Dyadic x = random.dyadic(7, -3);
    EXPECT_LE(abs(x), Dyadic(16)) << x;
    EXPECT_GE(x.sign() == 0 ? 0 : x.exponent(), -3) << x;
  }
}

TEST(Random, KeysThatDifferInOnePlaceOrInOrderGiveDifferentStreams) {
  std::set<std::uint64_t> first;
  for (std::uint64_t a = 0; a < 32; ++a) {
    for (std::uint64_t b = 0; b < 32; ++b) first.insert(Random::keyed({a, b}).next());
    first.insert(Random::keyed({a}).next());
  }
  EXPECT_EQ(first.size(), 32u * 33u);
}

}  // namespace
}  // namespace ccdfuzz
