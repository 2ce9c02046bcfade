#include "ccd/rational/window.hpp"

#include <cmath>

namespace ccdfuzz::exact_ccd {

namespace {

/// A new end on the far side of the separated times that begin at `from`, or `from` if none is
/// better. The gap is < 0 at `from` and > 0 at `to`; to < from means from the right.
double certified_end(Gap& gap, int below, double from, double to, double gap_from, double gap_to) {
  const double step = std::ldexp(1.0, gap.units().grid - gap.units().horizon);
  // t rounded to the grid towards `from`, after moving it by `slack` steps away from it.
  const auto outward = [&](double t, double slack) {
    const double steps = t / step;  // exact: step is a power of two
    return (from < to ? std::floor(steps + slack) : std::ceil(steps - slack)) * step;
  };
  const auto is_between = [&](double t, double end) {
    return from < to ? from < t && t < end : end < t && t < from;
  };
  const auto certifies = [&](double t) {
    return is_between(t, to) && gap.sign(below, t, gap.extremes(t)) <= 0;  // Law R3
  };
  // Newton's iteration on the convex gap from its non-negative side: approaches the root
  // monotonically, and reaches it when the last line is found. In double precision: any result is
  // only a proposal.
  constexpr int kMaxSteps = 8;
  double root = to, value = gap_to;
  for (int i = 0; i < kMaxSteps && value > gap.error(); ++i) {
    const double next = root - value / gap.slope(below, root);
    if (!is_between(next, root)) break;
    root = next;
    value = gap.extremes(root).gap(below);
  }
  // Roots this close to a grid point, in steps, are tried as that point. A root that is exactly on
  // the grid must not lose a step to the rounding of Newton's iteration. Speed only.
  constexpr double kNearGrid = 0x1p-10;
  const double near = outward(root, kNearGrid), next = near + (from < to ? -step : step);
  if (certifies(near)) return near;
  if (certifies(next)) return next;
  // By convexity the chord's root lies on the separated side of the gap's.
  const double chord = outward(from + (to - from) * (gap_from / (gap_from - gap_to)), 0);
  return certifies(chord) ? chord : from;
}

}  // namespace

bool cut_window(Gap& gap, Window& window) {
  Extremes at_lo = gap.extremes(window.lo);
  Extremes at_hi = window.lo == window.hi ? at_lo : gap.extremes(window.hi);
  for (int below = 0; below < 2; ++below) {
    const double gap_lo = at_lo.gap(below), gap_hi = at_hi.gap(below);
    if (gap_lo > gap.error() && gap_hi > gap.error()) continue;
    // Law R1: exact signs decide what is taken.
    const int sign_lo = gap.sign(below, window.lo, at_lo);
    const int sign_hi = window.lo == window.hi ? sign_lo : gap.sign(below, window.hi, at_hi);
    if (sign_lo < 0 && sign_hi < 0) return false;  // Law R2
    if (sign_lo < 0) {
      const double end = sign_hi == 0
                             ? window.hi
                             : certified_end(gap, below, window.lo, window.hi, gap_lo, gap_hi);
      if (end != window.lo) at_lo = gap.extremes(window.lo = end);
    } else if (sign_hi < 0) {
      const double end = sign_lo == 0
                             ? window.lo
                             : certified_end(gap, below, window.hi, window.lo, gap_hi, gap_lo);
      if (end != window.hi) at_hi = gap.extremes(window.hi = end);
    }
  }
  return true;
}

}  // namespace ccdfuzz::exact_ccd
