#include "ccd/rational/window.hpp"

#include "ccd_rational/setting.hpp"

namespace ccdfuzz::exact_ccd {
namespace {

struct ExactWindow {
  Rational lo, hi;
};

/// What cut_window did to a window, beside the separated times of both signs of the axis.
struct CutCase {
  ExactWindow before, after;
  Cut cut = Cut::kNothing;
  std::array<std::optional<SeparatedTimes>, 2> separated;
  Rational step;

  bool separates_all(const SeparatedTimes& s) const {
    return s.from_included && s.to_included && s.from == before.lo && s.to == before.hi;
  }
  bool separates_lo(const SeparatedTimes& s) const {
    return s.from_included && s.from == before.lo;
  }
  bool separates_hi(const SeparatedTimes& s) const { return s.to_included && s.to == before.hi; }

  /// Whether any sign of the axis separates at times for which `claim` holds.
  template <class Claim>
  bool any(const Claim& claim) const {
    return (separated[0] && claim(*separated[0])) || (separated[1] && claim(*separated[1]));
  }
};

CutCase cut(const Setting& s) {
  Gap gap;
  s.put(gap);
  const double a = any_window_end(s.query, gap.units()), b = any_window_end(s.query, gap.units());
  ScaledWindow window{gap.scaled(std::min(a, b)), gap.scaled(std::max(a, b))};
  CutCase c;
  const auto unscaled = [&] {
    return ExactWindow{exact(gap.unscaled(window.lo)), exact(gap.unscaled(window.hi))};
  };
  c.before = unscaled();
  c.cut = cut_window(gap, window);
  c.after = unscaled();
  c.step = power_of_two(gap.units().grid);
  RC_LOG() << "window [" << c.before.lo << ", " << c.before.hi << "] became [" << c.after.lo << ", "
           << c.after.hi << "], cut " << static_cast<int>(c.cut) << "\n";
  for (size_t below = 0; below < 2; ++below) {
    c.separated[below] =
        separated_times(s.lines(below), s.lines(1 - below), c.before.lo, c.before.hi);
    if (const auto& t = c.separated[below]) {
      RC_LOG() << "separated " << (t->from_included ? "[" : "(") << t->from << ", " << t->to
               << (t->to_included ? "]" : ")") << "\n";
    }
  }
  return c;
}

RC_GTEST_PROP(LawR1, LosesOnlyTimesThatAreSeparated, ()) {
  const CutCase c = cut(any_setting(3, 6));
  if (c.cut == Cut::kAll) {
    RC_ASSERT(c.any([&](const SeparatedTimes& s) { return c.separates_all(s); }));
    return;
  }
  RC_ASSERT(c.before.lo <= c.after.lo);
  RC_ASSERT(c.after.lo <= c.after.hi);
  RC_ASSERT(c.after.hi <= c.before.hi);
  if (c.after.lo > c.before.lo) {  // [before.lo, after.lo) was taken; an exact root stays
    RC_ASSERT(
        c.any([&](const SeparatedTimes& s) { return c.separates_lo(s) && c.after.lo <= s.to; }));
  }
  if (c.after.hi < c.before.hi) {
    RC_ASSERT(
        c.any([&](const SeparatedTimes& s) { return c.separates_hi(s) && c.after.hi >= s.from; }));
  }
  RC_ASSERT((c.cut == Cut::kNothing) == (c.before.lo == c.after.lo && c.before.hi == c.after.hi));
}

RC_GTEST_PROP(LawR2, IsEmptyWhereverOneAxisSeparatesThroughout, ()) {
  const CutCase c = cut(any_setting(3, 6));
  if (c.any([&](const SeparatedTimes& s) { return c.separates_all(s); })) {
    RC_ASSERT(c.cut == Cut::kAll);
  }
}

RC_GTEST_PROP(LawR3, MovesNoEndAtWhichTheGapIsNotNegative, ()) {
  const CutCase c = cut(any_setting(3, 6));
  if (!c.any([&](const SeparatedTimes& s) { return c.separates_lo(s); })) {
    RC_ASSERT(c.after.lo == c.before.lo);
  }
  if (!c.any([&](const SeparatedTimes& s) { return c.separates_hi(s); })) {
    RC_ASSERT(c.after.hi == c.before.hi);
  }
}

RC_GTEST_PROP(Window, EndsWithinTwoStepsOfTheRoot, ()) {
  Setting s;
  s.query = any_query(3, RandomCoordinates{*rc::gen::element(RandomCoordinates::kLattice,
                                                             RandomCoordinates::kDyadic)});
  s.query.t_max = *rc::gen::element(1.0, 2.0, 0.1, 1 + 0x1p-30, 3.0);
  const int depth = *rc::gen::inRange(0, 6);
  for (size_t side = 0; side < 2; ++side) {
    s.families[side] = any_family(s.query.patches[side].shape, depth);
  }
  s.axis = any_axis(*rc::gen::inRange(0, kMostAxisBits + 1));
  const CutCase c = cut(s);
  if (c.cut == Cut::kAll) return;
  for (const auto& times : c.separated) {
    if (!times) continue;
    if (c.separates_lo(*times)) RC_ASSERT(times->to - c.after.lo <= 2 * c.step);
    if (c.separates_hi(*times)) RC_ASSERT(c.after.hi - times->from <= 2 * c.step);
  }
}

}  // namespace
}  // namespace ccdfuzz::exact_ccd
