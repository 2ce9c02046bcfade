#pragma once

#include <array>
#include <span>

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// A unit vector, and how many cross products deep it is in Appendix A (c): component errors are
/// bounded by B = 2^stage·A^(stage+1) with k = 2·stage, and A ≤ 1 for unit vectors.
struct Axis {
  Vec3<double> direction;
  int stage = 0;
};

/// The separating axes of a pair of oriented boxes.
class Axes {
 public:
  static constexpr int kMax = 15;

  const Axis* begin() const { return axes_.data(); }
  const Axis* end() const { return axes_.data() + size_; }
  int size() const { return size_; }

  /// Adds the direction of v, unless v is zero or not finite: such an axis separates nothing.
  void add(const Vec3<double>& v, int stage);

 private:
  std::array<Axis, kMax> axes_;
  int size_ = 0;
};

/// A moving sub-patch: control points in Shape's order.
struct ControlNet {
  Shape shape;
  std::span<const Vec3<double>> positions;
  std::span<const Vec3<double>> velocities;
};

/// The OBB axes of Appendix A (c), each of unit length, for boxes aligned with the directions that
/// the sub-patches span at time t: l1, l2, l3 of patch 1, l4, l5, l6 of patch 2, then l_i ×
/// l_{j+3}. A curve spans one direction; the coordinate axis it is least aligned with stands in for
/// the other. A point spans none, and its box is a point in any frame. Where neither patch is a
/// surface and no axis is left, the coordinate axes are used. Safe: any vector is a valid axis, so
/// no rounding here can separate what touches.
Axes obb_axes(const ControlNet& patch1, const ControlNet& patch2, double t);

/// The coordinate axes.
Axes aabb_axes();

}  // namespace ccdfuzz
