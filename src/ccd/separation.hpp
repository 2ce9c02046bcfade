#pragma once

#include <optional>
#include <span>

#include "ccd/envelope.hpp"
#include "ccd/time_interval.hpp"

namespace ccdfuzz {

namespace detail {

/// Does line i of f cross line j of g (f + g = 0) before f's own turn to its next line, or before
/// the window ends? Eqs. 8 and 9, which differ only in which envelope is f.
/// step is +1 on the way from the left (f + g falls, end = tU) and −1 on the way back (f + g rises,
/// end = tL).
template <int step, class Policy, class S>
bool crosses_within(const Policy& policy, const Lines<S>& f, int i, const Line<S>& g,
                    const S& end) {
  const S slope(f[i].slope + g.slope), intercept(f[i].intercept + g.intercept);
  const int next = i + step;
  if (next < 0 || next == f.size()) return policy.negative(EndValue<S>{slope, intercept, end});
  const S next_slope(f[next].slope + g.slope), next_intercept(f[next].intercept + g.intercept);
  // The sign of slope turns with the direction, and the predicate with it.
  if constexpr (step > 0) {
    return policy.negative(ProductDifference<S>{next_slope, intercept, slope, next_intercept});
  } else {
    return policy.negative(ProductDifference<S>{slope, next_intercept, next_slope, intercept});
  }
}

}  // namespace detail

/// Where f + g < 0 on w (Step III, Eqs. 7–10, and its mirror image for the right end). f is the
/// upper envelope of patch 1's lines, g that of patch 2's negated ones. So f + g < 0 where patch 1
/// lies wholly below patch 2. f + g is convex, so the set is an interval.
/// Requires envelopes as upper_envelope leaves them, at least one line each.
/// Safe, for exact S: equal to that set. For double it is Policy's claim that it is a subset.
/// Nothing is returned where an end is not found.
template <class Policy, class S>
std::optional<SeparatedInterval<S>> separation(const Policy& policy, const Lines<S>& f,
                                               const Lines<S>& g, const TimeWindow<S>& w) {
  const auto sum_at = [](const Line<S>& x, const Line<S>& y, const S& t) {
    return EndValue<S>{S(x.slope + y.slope), S(x.intercept + y.intercept), t};
  };
  SeparatedInterval<S> found{w.lo, w.hi, true, true};
  if (!policy.starts_below(f[0], g[0], w.lo)) {  // Eq. 7
    int i = 0, j = 0;
    for (;;) {
      if (!(f[i].slope + g[j].slope < 0)) return std::nullopt;  // f + g no longer falls
      const bool passed_g = !detail::crosses_within<1>(policy, g, j, f[i], w.hi);
      const bool passed_f = (Policy::kAdvancesBoth || !passed_g) &&
                            !detail::crosses_within<1>(policy, f, i, g[j], w.hi);
      if (!passed_f && !passed_g) break;
      if (passed_g && ++j == g.size()) return std::nullopt;
      if (passed_f && ++i == f.size()) return std::nullopt;
    }
    found.lo = policy.left_root(f, g, i, j, w);
    found.has_lo = false;
  }
  int i = f.size() - 1, j = g.size() - 1;
  if (!policy.negative(sum_at(f[i], g[j], w.hi))) {
    for (;;) {
      if (!(f[i].slope + g[j].slope > 0)) return std::nullopt;
      const bool passed_g = !detail::crosses_within<-1>(policy, g, j, f[i], w.lo);
      const bool passed_f = (Policy::kAdvancesBoth || !passed_g) &&
                            !detail::crosses_within<-1>(policy, f, i, g[j], w.lo);
      if (!passed_f && !passed_g) break;
      if (passed_g && --j < 0) return std::nullopt;
      if (passed_f && --i < 0) return std::nullopt;
    }
    found.hi = policy.right_root(f, g, i, j, w);
    found.has_hi = false;
  }
  // A rounded root outside the window is taken as a sign that none of this can be relied on.
  if (found.lo < w.lo || w.hi < found.hi || found.empty()) return std::nullopt;
  return found;
}

/// The part of a separation on a wider window that lies in w: it holds an end of w that it reaches
/// past. Nothing if it has none.
template <class S>
std::optional<SeparatedInterval<S>> clipped_to(const TimeWindow<S>& w, SeparatedInterval<S> s) {
  s.has_lo = s.lo < w.lo;
  s.has_hi = w.hi < s.hi;
  if (s.has_lo) s.lo = w.lo;
  if (s.has_hi) s.hi = w.hi;
  if (s.empty()) return std::nullopt;
  return s;
}

/// What is left of w once the separations are taken out: the closed hull, or nothing if they cover
/// w. Intervals merge only where they share a point: between two that end in the same root, that
/// root is a touch and stays.
template <class S>
std::optional<TimeWindow<S>> remaining_window(std::span<const SeparatedInterval<S>> separations,
                                              const TimeWindow<S>& w) {
  S lo = w.lo;
  for (bool moved = true; moved;) {
    moved = false;
    for (const SeparatedInterval<S>& s : separations) {
      if (!s.contains(lo)) continue;
      if (s.has_hi) return std::nullopt;
      lo = s.hi;
      moved = true;
    }
  }
  S hi = w.hi;
  for (bool moved = true; moved;) {
    moved = false;
    for (const SeparatedInterval<S>& s : separations) {
      if (!s.contains(hi)) continue;
      hi = s.lo;  // s.lo is not in s: else s would reach back to lo
      moved = true;
    }
  }
  return TimeWindow<S>{lo, hi};
}

}  // namespace ccdfuzz
