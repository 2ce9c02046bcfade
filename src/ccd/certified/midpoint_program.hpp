#pragma once

#include <vector>

#include "bezier/shape.hpp"

namespace ccdfuzz::certified {

/// The midpoint split of a shape as a list of averages. Slots 0..control_count−1 hold the parent's
/// control points. Step s fills slot control_count + s with the mean of two earlier slots. At the
/// end control point i of child c (numbered as Cell::child) is slot children[c][i]. Every value is
/// made once, also where children share it.
struct MidpointProgram {
  struct Step {
    int left, right;
  };
  std::vector<Step> steps;
  std::vector<std::vector<int>> children;
  /// No slot has more than this many roundings behind it: one per argument of the blossom. Law C
  /// counts them.
  int roundings = 0;

  explicit MidpointProgram(const Shape& shape);
};

}  // namespace ccdfuzz::certified
