#pragma once

#include <algorithm>

namespace ccdfuzz {

/// A part [lo, hi] of the time step, closed.
template <class S>
struct TimeWindow {
  S lo;
  S hi;
};

/// A closed time interval in which a pair of cells may touch; lo ≤ hi, or nothing is left of it.
using Window = TimeWindow<double>;

/// What two windows share; none where lo > hi.
inline Window intersection(const Window& v, const Window& w) {
  return {std::max(v.lo, w.lo), std::min(v.hi, w.hi)};
}

/// An interval of time in which an axis separates two patches. It holds an end only if it was cut
/// off there by the window: elsewhere the end is a root, at which the boxes touch.
template <class S>
struct SeparatedInterval {
  S lo;
  S hi;
  bool has_lo = false;
  bool has_hi = false;

  bool contains(const S& t) const {
    return (lo < t || (has_lo && lo == t)) && (t < hi || (has_hi && t == hi));
  }
  bool empty() const { return hi < lo || (lo == hi && !(has_lo && has_hi)); }
};

}  // namespace ccdfuzz
