// Inputs by hand that show what the properties of Steps II and III claim of drawn ones.
#include "properties/separation.hpp"

#include <gtest/gtest.h>

#include "ccd/separation.hpp"
#include "properties/envelope.hpp"
#include "properties/exact_lines.hpp"

namespace ccdfuzz {
namespace {

/// True iff the method takes a time for separated that is not.
template <class Policy>
bool excludes_too_much(const LinePairs& pairs) {
  try {
    claim_separation_is_true<Policy>(pairs);
    return false;
  } catch (const Refuted&) {
    return true;
  }
}

/// The lines of twin_shield() on the axis z. The second line is redundant by less than the bound,
/// so it stays, and the third shields it from the fourth. The chain fails to be convex by O(1),
/// which no bound of rounding covers.
TEST(Separation, PrintedSignLosesATwinShieldByMuch) {
  const LinePairs p{{{2, -1}, {.3, -.25}, {.1 * 3, -.25}, {0, 0}}, {{-10, 7}}, {0, 1}};
  const ErrorBoundPrinted policy;
  const auto printed = separation(policy, envelope_of(policy, p.f, p.window),
                                  envelope_of(policy, p.g, p.window), p.window);
  ASSERT_TRUE(printed.has_value());
  EXPECT_LT(printed->lo, .75 - .01) << "exact: separated after 3/4";
  EXPECT_TRUE(excludes_too_much<ErrorBoundPrinted>(p));
  EXPECT_FALSE(excludes_too_much<ErrorBoundIntended>(p));
  EXPECT_FALSE(excludes_too_much<Plain>(p));
}

/// C.3 claims that envelopes pulled apart by I·delta make the root safe. As a lemma on exact
/// envelopes it is false: the proof bounds the pairs that the sweep visited, and here it stops
/// before the pair that decides. That eps_constr covers it here is luck, not proof.
TEST(Separation, PullingApartByIDeltaIsNotEnoughOnItsOwn) {
  const LinePairs p{{{-1, .35}, {.5, -.25}, {.99, -.495 - 0x1p-54}},
                    {{-1 - 38 * 0x1p-52, .5 + 57 * 0x1p-53}, {-1, .5}},
                    {0, 1}};
  const ErrorBoundIntended policy;
  Lines<double> f, g;
  upper_envelope(policy, sorted_lines(p.f), p.window, f);
  upper_envelope(policy, sorted_lines(p.g), p.window, g);
  const auto found = separation(policy, f, g, p.window);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->lo, .50000000000002542);
  const Dyadic later = Dyadic::exact(.50000000000020517);
  EXPECT_GT((maximum(exact_lines(f), later) + maximum(exact_lines(g), later)).sign(), 0);
  EXPECT_FALSE(excludes_too_much<ErrorBoundIntended>(p)) << "eps_constr included";
}

/// Theorem 4.1 has no term for underflow: products of two tiny numbers vanish, and their bounds
/// with them.
TEST(Separation, ErrorBoundExcludesTooMuchWhereProductsUnderflow) {
  const double unit = std::numeric_limits<double>::denorm_min();
  const LinePairs p{{{0, -unit}, {0x24 * unit, -0x1b * unit}, {0x28 * unit, -0x48 * unit}},
                    {{0, -2 * unit}},
                    {0, 1}};
  EXPECT_TRUE(excludes_too_much<ErrorBoundIntended>(p));
}

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
