#include "certify/checker/copositive.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "numeric/dyadic.hpp"

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

// Exhaustive on small integers, where the grid is fine enough to see each negative value.
TEST(Copositive, AgreesWithTheGridOnAllSmallIntegers) {
  int accepted = 0, refused = 0;
  for (int number = 0; number < 4 * 4 * 4 * 7 * 7 * 7; ++number) {
    Coefficients h{};
    int rest = number;
    for (const size_t corner : {0U, 2U, 5U}) h[corner] = rest % 4, rest /= 4;
    for (const size_t side : {1U, 3U, 4U}) h[side] = rest % 7 - 3, rest /= 7;
    const bool yes = decide(h);
    ++(yes ? accepted : refused);
    ASSERT_EQ(yes, !negative_on_grid(h))
        << fmt::format("coefficients w2 vw v2 uw uv u2: {}", fmt::join(h, " "));
  }
  // Neither answer is rare.
  EXPECT_GT(accepted, 5000);
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace ccdfuzz
