// GoogleTest as the driver: the same claims on named inputs.
#include <gtest/gtest.h>

#include <limits>

#include "properties/dyadic_round_trip.hpp"
#include "properties/envelope.hpp"
#include "properties/sub_patch.hpp"

namespace ccdfuzz {
namespace {

using Status = Check::Status;

TEST(DyadicRoundTrip, AtTheEndsOfTheRange) {
  constexpr double kMax = std::numeric_limits<double>::max();
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  for (const double x : {0.0, -0.0, 0.1, kMax, -kMax, kTiny, -kTiny, 0x1p-1022}) {
    for (const double y : {0.0, 1.0, kMax, kTiny}) {
      const Check check = dyadic_round_trip(x, y);
      EXPECT_EQ(check.status, Status::kHolds) << check.text;
    }
  }
}

TEST(SubPatch, OfAnInvertedTriangle) {
  const Shape shape = Shape::triangle(2);
  Points<Dyadic> points;
  for (int i = 0; i < 6; ++i) points.push_back({Dyadic(i), Dyadic(i * i), Dyadic(3 * i - i * i)});
  const Cell middle = Cell().child(shape, 3);
  const Check check =
      sub_patch_is_the_restriction(shape, points, middle, {Dyadic(1, -2), Dyadic(1, -1)});
  EXPECT_EQ(check.status, Status::kHolds) << check.text;
}

/// Three lines almost through one point, the middle one below by less than a float can tell: the
/// printed sign keeps it, and a fourth line then hides behind its twin.
TEST(Separation, TwinShieldMisleadsTheSignAsPrinted) {
  // f: 0·t − 0.5 against a chain of twins; see below.
  const LinePairs pairs{{{0, -1}, {1, -0x1p-1}, {1 + 0x1p-52, -0x1p-1 - 0x1p-54}, {2, 0.25}},
                        {{-0.5, -0.25}},
                        {0, 1}};
  EXPECT_EQ(separation_is_true(ErrorBoundIntended(), pairs).status, Status::kHolds);
}

}  // namespace
}  // namespace ccdfuzz
