#include "base/nearest_float.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ccdfuzz {

/// Not of this file alone, lest it is compiled for the numbers of the test.
void round_all(double* p);
[[gnu::noinline]] void round_all(double* p) {
  for (int k = 0; k < 3; ++k) p[k] = nearest_float(p[k]);
}

namespace {

// This file is compiled as the sources are, for speed.
TEST(NearestFloat, IsOneInALoopOverCoordinates) {
  const volatile double tenth = 0.1;  // nothing is computed while compiling
  std::array<double, 3> p = {tenth, 2 * tenth, 0.5 * tenth};
  round_all(p.data());
  EXPECT_EQ(p, (std::array<double, 3>{0x1.99999ap-4, 0x1.99999ap-3, 0x1.99999ap-5}));
}

TEST(NearestFloat, RoundsToEvenAndKeepsWhatIsNoNumber) {
  EXPECT_EQ(nearest_float(0x1.000001p0), 1);
  EXPECT_EQ(nearest_float(0x1.000003p0), 0x1.000004p0);
  EXPECT_EQ(nearest_float(0x1p-150), 0);
  EXPECT_EQ(nearest_float(-0x1.8p-149), -0x1p-148);
  EXPECT_EQ(nearest_float(0x1p128), HUGE_VAL);
}

}  // namespace
}  // namespace ccdfuzz
