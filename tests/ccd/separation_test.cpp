#include "ccd/separation.hpp"

#include <gtest/gtest.h>

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

TEST(RemainingWindow, KeepsATouchBetweenTwoSeparations) {
  const std::array<SeparatedInterval<double>, 2> s = {{{0, .5, true, false}, {.5, 1, false, true}}};
  const auto w = remaining_window<double>(s, {0, 1});
  ASSERT_TRUE(w.has_value());
  EXPECT_EQ(w->lo, .5);
  EXPECT_EQ(w->hi, .5);
}

TEST(RemainingWindow, KeepsATouchAtEitherEnd) {
  const std::array<SeparatedInterval<double>, 1> after_start = {{{0, 1, false, true}}};
  const auto start = remaining_window<double>(after_start, {0, 1});
  ASSERT_TRUE(start.has_value());
  EXPECT_EQ(start->lo, 0);
  EXPECT_EQ(start->hi, 0);
  const std::array<SeparatedInterval<double>, 1> before_end = {{{0, 1, true, false}}};
  const auto end = remaining_window<double>(before_end, {0, 1});
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->lo, 1);
  EXPECT_EQ(end->hi, 1);
}

TEST(RemainingWindow, MergesSeparationsThatOverlap) {
  const std::array<SeparatedInterval<double>, 3> s = {
      {{.6, 1, false, true}, {.25, .75, false, false}, {0, .5, true, false}}};
  EXPECT_FALSE(remaining_window<double>(s, {0, 1}).has_value());
}

TEST(RemainingWindow, KeepsWhatLiesBetween) {
  const std::array<SeparatedInterval<double>, 3> s = {
      {{.75, 1, false, true}, {0, .25, true, false}, {.4, .5, false, false}}};
  const auto w = remaining_window<double>(s, {0, 1});
  ASSERT_TRUE(w.has_value());
  EXPECT_EQ(w->lo, .25);
  EXPECT_EQ(w->hi, .75);
}

}  // namespace
}  // namespace ccdfuzz
