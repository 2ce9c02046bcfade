#include "base/fp_guard.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

namespace ccdfuzz {
namespace {

TEST(FpGuard, RestoresTheRoundingModeOfTheHost) {
  const int before = std::fegetround();
  std::fesetround(FE_UPWARD);
  volatile double one = 1;
  EXPECT_FALSE(FpGuard::holds());
  EXPECT_GT(one + 0x1p-60, 1);
  {
    const FpGuard guard;
    EXPECT_TRUE(FpGuard::holds());
    EXPECT_EQ(one + 0x1p-60, 1);
  }
  EXPECT_GT(one + 0x1p-60, 1);
  std::fesetround(before);
}

TEST(FpGuard, ChangesNothingWithinAnother) {
  const FpGuard outer;
  {
    const FpGuard inner;
    EXPECT_TRUE(FpGuard::holds());
  }
  EXPECT_TRUE(FpGuard::holds());
  volatile double least_normal = std::numeric_limits<double>::min();
  EXPECT_NE(least_normal / 2, 0.0);
}

}  // namespace
}  // namespace ccdfuzz
