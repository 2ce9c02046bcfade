#pragma once

#include "ccd/time_interval.hpp"
#include "numeric/vec3.hpp"

namespace ccdfuzz {

/// What one axis takes from a pair of parts in an inclusion test: the times at which, so the method
/// claims, it separates the two. Times are the method's own: tdibm-c scales them by a power of two.
struct ExcludedInterval {
  int axis = -1;  ///< place among the axes that the method tries, from 0
  Vec3<double> direction = Vec3<double>(0, 0, 0);  ///< the axis', of any length
  int below = 0;  ///< which patch is the lower one along it, 0 or 1
  SeparatedInterval<double> times;
};

/// How far an axis is from excluding a window, at both its ends. It is the upper end of the lower
/// part less the lower end of the upper part, plus what the method allows for rounding. The axis
/// excludes an end at which this is negative. The unit is the error bound of tdibm-c, and an ulp of
/// the heights for trad.
struct SignedGap {
  int axis = -1;
  Vec3<double> direction = Vec3<double>(0, 0, 0);
  int below = 0;
  TimeWindow<double> window{};
  double at_lo = 0, at_hi = 0;
  double in_units_of = 1;
};

/// An inclusion test reports each axis to its observer, if it has one.
class ExclusionObserver {
 public:
  virtual void excluded(const ExcludedInterval& exclusion) = 0;
  /// By the methods that compare at the ends of a window: trad and tdibm-c.
  virtual void compared(const SignedGap& gap) = 0;

 protected:
  ~ExclusionObserver() = default;
};

}  // namespace ccdfuzz
