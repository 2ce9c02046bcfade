#include "certify/checker/copositive.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

using Coefficients = std::array<int, 6>;

bool decide(const Coefficients& h) {
  std::array<Dyadic, 6> heights;
  for (size_t i = 0; i < 6; ++i) heights[i] = Dyadic(h[i]);
  return nonnegative_on_triangle(heights);
}

/// True iff the quadratic is negative at some point with barycentric coordinates in steps of 1/32.
bool negative_on_grid(const Coefficients& h) {
  constexpr int kSteps = 32;
  for (int u = 0; u <= kSteps; ++u) {
    for (int v = 0; u + v <= kSteps; ++v) {
      const int w = kSteps - u - v;
      const int value = h[0] * w * w + h[2] * v * v + h[5] * u * u +
                        2 * (h[1] * v * w + h[3] * u * w + h[4] * u * v);
      if (value < 0) return true;
    }
  }
  return false;
}

std::string text(const Coefficients& h) {
  return fmt::format("coefficients w2 vw v2 uw uv u2: {}", fmt::join(h, " "));
}

// Exhaustive on small integers, where the grid is fine enough to see each negative value.
TEST(Copositive, AgreesWithTheGridOnAllSmallIntegers) {
  int accepted = 0, refused = 0;
  Coefficients h{};
  for (h[0] = 0; h[0] <= 3; ++h[0]) {
    for (h[2] = 0; h[2] <= 3; ++h[2]) {
      for (h[5] = 0; h[5] <= 3; ++h[5]) {
        for (h[1] = -3; h[1] <= 3; ++h[1]) {
          for (h[3] = -3; h[3] <= 3; ++h[3]) {
            for (h[4] = -3; h[4] <= 3; ++h[4]) {
              const bool yes = decide(h);
              ++(yes ? accepted : refused);
              ASSERT_EQ(yes, !negative_on_grid(h)) << text(h);
            }
          }
        }
      }
    }
  }
  // Neither answer is rare.
  EXPECT_GT(accepted, 5000);
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace ccdfuzz
