#pragma once

#include "ccd/axes.hpp"
#include "ccd/robustness.hpp"

namespace ccdfuzz {

/// The lines of a sub-patch on an axis (Step I, Appendix A (d)), sorted.
void project(const ControlNet& net, const Axis& axis, Lines<double>& out);

/// The largest component of some points, in magnitude.
double largest_component(const Points<double>& points);

/// The largest component of a patch's original control points and velocities, P and Ṗ of
/// Appendix A.
struct LargestComponents {
  double position = 0;
  double velocity = 0;
};
LargestComponents largest_components_of(const MovingPatch<double>& patch);

/// Appendix A (d): how far the lines of any sub-patch of a patch on an axis, made by restrict_to
/// and project, are claimed to be off at most.
CoefficientError coefficient_error(const Shape& shape, const LargestComponents& extent,
                                   const Axis& axis);

}  // namespace ccdfuzz
