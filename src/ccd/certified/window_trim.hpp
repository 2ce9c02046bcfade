#pragma once

#include "base/verify.hpp"
#include "ccd/certified/projection.hpp"
#include "ccd/time_interval.hpp"
#include "numeric/next_double.hpp"

namespace ccdfuzz::certified {

/// Two nets whose separation on one axis is in question. h(t) = max of one − min of the other is
/// convex in t, so that h certified negative at two times is negative between them. That holds for
/// nets with weights, too: those do not move, so what is divided by them moves linearly.
struct NetPair {
  const double* net[2];
  int count[2];
};

/// fl(h) at both window ends, for side 0 below side 1 (sign 0) and above it (sign 1).
/// Law A: control points move linearly, so h is convex; h < 0 at both ends implies h < 0 between.
struct Gaps {
  std::array<double, 2> at_lo, at_hi;
  [[no_unique_address]] Provenance of{};

  /// Separated throughout the window, certainly. bound: E of Law C, and what a separation adds.
  bool separated(double bound) const {
    // Laws A and C
    return (at_lo[0] < -bound && at_hi[0] < -bound) || (at_lo[1] < -bound && at_hi[1] < -bound);
  }
};

/// Those on axis k of a batch. Requires extents at the ends of one window.
inline Gaps gaps_of(const RangeBatch& a, const RangeBatch& b, int k) {
  CCDFUZZ_ASSERT(b.of.is_of(a.of.window));
  return {{a.max_lo[k] - b.min_lo[k], b.max_lo[k] - a.min_lo[k]},
          {a.max_hi[k] - b.min_hi[k], b.max_hi[k] - a.min_hi[k]},
          a.of};
}

/// Where the chord through (t0, h0) and (t1, h1), h0 < 0 ≤ h1, reaches zero, rounded towards t0.
/// Law B: if h0 and h1 are upper bounds of h, then h < 0 from t0 up to, but without, the result, as
/// h is convex.
/// The quotient is in [0, 1]. t1 may be < t0.
inline double chord_root(double t0, double h0, double t1, double h1) {
  CCDFUZZ_ASSERT(h0 < 0 && 0 <= h1);
  const double share = (-h0 / (h1 - h0)) * (1 - 0x1p-50);
  // Five roundings, ≤ 5·2^-53 < 2^-50: two of the quotient, and those of the factor, of t1 - t0 and
  // of the product.
  const double t = t0 + (t1 - t0) * share;
  // The last sum rounds by half an ulp of t: one step back covers it.
  const double root = t0 < t1 ? std::max(t0, next_down(t)) : std::min(t0, next_up(t));
  CCDFUZZ_ASSERT(std::min(t0, t1) <= root && root <= std::max(t0, t1));
  // The chord is not above 0 at the root, but for ten roundings of this check.
  CCDFUZZ_ASSERT((root - t0) / (t1 - t0) * (h1 - h0) <= -h0 * (1 + 0x1p-49));
  return root;
}

/// Moves the ends of w inward by what the chord of each end allows (Law B); free of further
/// evaluation. Requires that the gaps are those at the ends of w.
inline void trim_by_chord(const Gaps& gaps, double bound, Window& w) {
  CCDFUZZ_ASSERT(gaps.of.is_of(w));
  const Window whole = w;
  for (int sign = 0; sign < 2; ++sign) {
    const double h_lo = gaps.at_lo[sign] + bound, h_hi = gaps.at_hi[sign] + bound;
    // Law B: fl(gap + bound) is an upper bound of h up to one rounding, the last one that
    // kFixedRoundings counts.
    if (gaps.at_lo[sign] < -bound && h_hi >= 0) {
      w.lo = std::max(w.lo, chord_root(whole.lo, h_lo, whole.hi, h_hi));
    } else if (gaps.at_hi[sign] < -bound && h_lo >= 0) {
      w.hi = std::min(w.hi, chord_root(whole.hi, h_hi, whole.lo, h_lo));
    }
  }
  // The chord leaves the other end, where h is not certified.
  CCDFUZZ_ASSERT(w.lo == whole.lo || (whole.lo < w.lo && w.lo < whole.hi));
  CCDFUZZ_ASSERT(w.hi == whole.hi || (whole.lo < w.hi && w.hi < whole.hi));
}

/// h(t) of two nets on one axis, and its slope where it has one. A line's height at t is rounded in
/// another order than a point's (kernels.hpp). Law C covers both.
class HeightLines {
 public:
  struct Gap {
    double height, slope;  ///< those of h
  };

  HeightLines(const NetPair& nets, const Axis& axis);

  Range extent(int side, double t) const;
  /// below: which side is the lower one, as `sign` in Gaps.
  Gap gap(int below, double t) const;

 private:
  using PerPoint = std::array<double, kMaxControls>;

  std::array<int, 2> counts_;
  std::array<PerPoint, 2> slopes_, intercepts_;
};

/// Moves one end of w inward, to a time at which separation is certified again (Law C). Law A
/// covers the time between. low_end: w.lo moves, otherwise w.hi. Newton's iteration starts from the
/// other end of `seen`, the window that the chords of both signs left. sign: which side is below;
/// both signs start from the same window, so exchanging the patches changes no result. Requires
/// that the axis certifies separation at the end that moves. If a chord has moved that end before,
/// the axis certified it where the end was. Returns false if no step was certified.
bool trim_by_newton(const HeightLines& lines, double bound, int sign, bool low_end,
                    const Window& seen, Window& w);

}  // namespace ccdfuzz::certified
