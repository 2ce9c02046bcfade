// GoogleTest as the driver: the same claims on named inputs.
#include <gtest/gtest.h>

#include <limits>

#include "properties/dyadic_round_trip.hpp"
#include "properties/sub_patch.hpp"

namespace ccdfuzz {
namespace {

TEST(DyadicRoundTrip, AtTheEndsOfTheRange) {
  constexpr double kMax = std::numeric_limits<double>::max();
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, -0.0, 0.1, kMax, -kMax, kTiny, -kTiny, 0x1p-1022}) {
    for (const double y : {0.0, 1.0, kMax, kTiny}) {
      EXPECT_NO_THROW(claim_dyadic_round_trip(x, y)) << to_hex(x) << ", " << to_hex(y);
    }
  }
}

TEST(SubPatch, IsRightForAnInvertedTriangle) {
  const Shape shape = Shape::triangle(2);
  Points<Dyadic> points;
  for (int i = 0; i < 6; ++i) points.push_back({Dyadic(i), Dyadic(i * i), Dyadic(3 * i - i * i)});
  const Cell middle = Cell().child(shape, 3);
  EXPECT_NO_THROW(
      claim_sub_patch_is_the_restriction(shape, points, middle, {Dyadic(1, -2), Dyadic(1, -1)}));
}

}  // namespace
}  // namespace ccdfuzz
