// GoogleTest as the driver: the same claims on named inputs.
#include <gtest/gtest.h>

#include <limits>

#include "ccd/separation.hpp"
#include "properties/dyadic_round_trip.hpp"
#include "properties/separation.hpp"
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

/// t − 7/8 and its twin lie below the maximum of 0 and 2t − 13/8 by 1/16 and more. The printed sign
/// keeps the first because Phi cannot tell it from its twin. It keeps both because the twin shields
/// the first from the last line. So the sweep takes t − 7/8 for the maximum where 0 is higher. It
/// says that the patches are separated up to 25/32, though they touch at 3/4.
TEST(Separation, TwinShieldMisleadsTheSignAsPrinted) {
  const LinePairs pairs{
      {{0, 0}, {1, -0.875}, {1 + 0x1p-52, -0.875}, {2, -1.625}}, {{2, -1.5}}, {0, 1}};
  EXPECT_NO_THROW(claim_separation_is_true<Plain>(pairs));
  EXPECT_NO_THROW(claim_separation_is_true<ErrorBoundIntended>(pairs));
  EXPECT_THROW(claim_separation_is_true<ErrorBoundPrinted>(pairs), Refuted);
}

}  // namespace
}  // namespace ccdfuzz
