#include "ccd/separation.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ccdfuzz {
namespace {

/// C.3 says that every pair of the path but the last has c_beta > c_(alpha+1). Here f has one line.
TEST(Separation, ThePathAdvancesTheOtherEnvelopeAlone) {
  Lines<double> f, g;
  f.push_back({-1, .5});
  g.push_back({-1, .25});
  g.push_back({0, 0});
  const auto found = separation(ErrorBoundIntended(), f, g, TimeWindow<double>{0, 1});
  ASSERT_TRUE(found.has_value());
  EXPECT_GE(found->lo, .5);
  EXPECT_LT(found->lo, .5 + 0x1p-40);
}

/// Both ends of the wider window are past those of the window, so a root there is past them too.
TEST(ClippedTo, HoldsAnEndOfTheWindowThatItReachesPast) {
  const TimeWindow<double> w{.25, .75};
  const auto clipped = [&w](double lo, double hi) {
    return clipped_to(w, SeparatedInterval<double>{lo, hi, lo == 0, hi == 1});
  };
  EXPECT_TRUE(clipped(0, .5)->has_lo && !clipped(0, .5)->has_hi);
  EXPECT_TRUE(!clipped(.5, 1)->has_lo && clipped(.5, 1)->has_hi);
  EXPECT_TRUE(clipped(.125, .875)->contains(.25) && clipped(.125, .875)->contains(.75));
  EXPECT_FALSE(clipped(.25, .75)->contains(.25)) << "a root at the start of the window is a touch";
  EXPECT_FALSE(clipped(.25, .75)->contains(.75)) << "so is one at its end";
  EXPECT_FALSE(clipped(0, .25));
  EXPECT_FALSE(clipped(.75, 1));
  EXPECT_FALSE(clipped(.8, .9));
}

TEST(RemainingWindow, IsWhatNoSeparationTakes) {
  using Separations = std::vector<SeparatedInterval<double>>;
  const auto expect_left = [](const Separations& separations, double lo, double hi) {
    const auto left = remaining_window<double>(separations, {0, 1});
    ASSERT_TRUE(left.has_value());
    EXPECT_EQ(left->lo, lo);
    EXPECT_EQ(left->hi, hi);
  };
  // A touch between two of them, or at either end.
  expect_left({{0, .5, true, false}, {.5, 1, false, true}}, .5, .5);
  expect_left({{0, 1, false, true}}, 0, 0);
  expect_left({{0, 1, true, false}}, 1, 1);
  expect_left({{.75, 1, false, true}, {0, .25, true, false}, {.4, .5, false, false}}, .25, .75);
  const Separations overlapping = {
      {.6, 1, false, true}, {.25, .75, false, false}, {0, .5, true, false}};
  EXPECT_FALSE(remaining_window<double>(overlapping, {0, 1}).has_value());
}

}  // namespace
}  // namespace ccdfuzz
