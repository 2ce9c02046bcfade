#include "ccd/rational/window.hpp"

#include <cmath>

namespace ccdfuzz::exact_ccd {

namespace {

/// Finds and certifies a new end on the far side of the separated times that begin at `from`.
class RootRounding {
 public:
  /// The gap is < 0 at `from` and > 0 at `to`; to < from means from the right.
  RootRounding(Gap& gap, int below, double from, double to)
      : gap_(gap),
        below_(below),
        from_(from),
        to_(to),
        step_(std::ldexp(1.0, gap.units().grid - gap.units().horizon)) {}

  /// The new end, or `from` if none is better.
  double find(double gap_from, double gap_to) {
    const double root = newton(gap_to);
    if (certify(outward(root, kNearGrid))) return found_;
    if (certify(found_ + (from_ < to_ ? -step_ : step_))) return found_;
    // By convexity the chord's root lies on the separated side of the gap's.
    const double chord = from_ + (to_ - from_) * (gap_from / (gap_from - gap_to));
    return certify(outward(chord, 0)) ? found_ : from_;
  }

 private:
  /// Roots this close to a grid point, in steps, are tried as that point. A root that is exactly on
  /// the grid must not lose a step to the rounding of Newton's iteration. Speed only.
  static constexpr double kNearGrid = 0x1p-10;

  /// Newton's iteration on the convex gap from its non-negative side: approaches the root
  /// monotonically, and reaches it when the last line is found. In double precision: any result
  /// is only a proposal.
  double newton(double gap_to) const {
    constexpr int kMaxSteps = 8;
    double t = to_, value = gap_to;
    for (int i = 0; i < kMaxSteps && value > gap_.error(); ++i) {
      const double slope = gap_.slope(below_, t);
      const double next = t - value / slope;
      if (!(from_ < to_ ? from_ < next && next < t : t < next && next < from_)) break;
      t = next;
      value = gap_.extremes(t).gap(below_);
    }
    return t;
  }

  /// t rounded to the grid towards `from`, after moving it by `slack` steps away from it.
  double outward(double t, double slack) const {
    const double steps = t / step_;  // exact: step_ is a power of two
    return (from_ < to_ ? std::floor(steps + slack) : std::ceil(steps - slack)) * step_;
  }

  /// Accepts t iff it lies strictly between both ends and the exact gap is ≤ 0 there.
  bool certify(double t) {
    found_ = t;
    if (!(from_ < to_ ? from_ < t && t < to_ : to_ < t && t < from_)) return false;
    return gap_.sign(below_, t, gap_.extremes(t)) <= 0;  // Law R3
  }

  Gap& gap_;
  int below_;
  double from_, to_, step_;
  double found_ = 0;
};

}  // namespace

Cut cut_window(Gap& gap, ScaledWindow& window) {
  const ScaledWindow before = window;
  Extremes at_lo = gap.extremes(window.lo);
  Extremes at_hi = window.lo == window.hi ? at_lo : gap.extremes(window.hi);
  for (int below = 0; below < 2; ++below) {
    const double gap_lo = at_lo.gap(below), gap_hi = at_hi.gap(below);
    if (gap_lo > gap.error() && gap_hi > gap.error()) continue;
    // Law R1: exact signs decide what is taken.
    const int sign_lo = gap.sign(below, window.lo, at_lo);
    const int sign_hi = window.lo == window.hi ? sign_lo : gap.sign(below, window.hi, at_hi);
    if (sign_lo < 0 && sign_hi < 0) return Cut::kAll;  // Law R2
    if (sign_lo < 0) {
      const double end = sign_hi == 0
                             ? window.hi
                             : RootRounding(gap, below, window.lo, window.hi).find(gap_lo, gap_hi);
      if (end != window.lo) at_lo = gap.extremes(window.lo = end);
    } else if (sign_hi < 0) {
      const double end = sign_lo == 0
                             ? window.lo
                             : RootRounding(gap, below, window.hi, window.lo).find(gap_hi, gap_lo);
      if (end != window.hi) at_hi = gap.extremes(window.hi = end);
    }
  }
  return window.lo == before.lo && window.hi == before.hi ? Cut::kNothing : Cut::kShorter;
}

}  // namespace ccdfuzz::exact_ccd
