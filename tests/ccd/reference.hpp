#pragma once

#include <algorithm>
#include <optional>

#include "ccd/separation.hpp"
#include "ccd/time_interval.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// Where f + g < 0 on w, f the maximum of the lines f and g that of the lines g, from all pairs of
/// lines: no envelope, no order, no predicate that Steps II and III use.
inline std::optional<SeparatedInterval<Rational>> all_pairs_separation(
    const Lines<Rational>& f, const Lines<Rational>& g, const TimeWindow<Rational>& w) {
  SeparatedInterval<Rational> s{w.lo, w.hi, true, true};
  for (const Line<Rational>& x : f) {
    for (const Line<Rational>& y : g) {
      const Rational slope(x.slope + y.slope), intercept(x.intercept + y.intercept);
      if (slope == 0) {
        if (intercept >= 0) return std::nullopt;
        continue;
      }
      const Rational root(-intercept / slope);
      // The pair is negative after its root, or before it; the root itself is not.
      if (slope < 0 && root >= s.lo) {
        s.lo = root;
        s.has_lo = false;
      }
      if (slope > 0 && root <= s.hi) {
        s.hi = root;
        s.has_hi = false;
      }
    }
  }
  if (s.empty()) return std::nullopt;
  return s;
}

/// Is every time of `found` in `exact_set`?
inline bool is_subset(const SeparatedInterval<double>& found,
                      const std::optional<SeparatedInterval<Rational>>& exact_set) {
  if (!exact_set) return false;
  const Rational lo = exact(found.lo), hi = exact(found.hi);
  const bool lo_fits =
      exact_set->lo < lo || (exact_set->lo == lo && (exact_set->has_lo || !found.has_lo));
  const bool hi_fits =
      hi < exact_set->hi || (exact_set->hi == hi && (exact_set->has_hi || !found.has_hi));
  return lo_fits && hi_fits;
}

}  // namespace ccdfuzz
