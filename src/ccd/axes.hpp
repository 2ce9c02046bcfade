#pragma once

#include <array>
#include <span>

#include "bezier/patch.hpp"
#include "ccd/reading.hpp"

namespace ccdfuzz {

/// A moving sub-patch: control points in Shape's order.
struct ControlNet {
  Shape shape;
  std::span<const Vec3<double>> positions;
  std::span<const Vec3<double>> velocities;
};

/// A separating axis of any length. A zero axis separates nothing and is skipped. stage is how many
/// cross products deep it is. By Appendix A (c) the errors of its components are bounded by B =
/// 2^stage·A^(stage+1) with k = 2·stage. A ≤ 1 where the spans have unit length.
struct Axis {
  Vec3<double> direction;
  int stage = 0;

  bool is_zero() const { return direction[0] == 0 && direction[1] == 0 && direction[2] == 0; }
};

/// A box's own axes.
using Frame = std::array<Vec3<double>, 3>;

/// The OBB frame of Appendix A (c) from the directions l_u, l_v that a part of patch `side`, 0 or
/// 1, spans at time t: l_u, l_u × l_v, l_u × (l_u × l_v). A curve spans one direction; the
/// coordinate axis it is least aligned with stands in for the other. A point spans none: its frame
/// is zero.
Frame obb_frame(const ControlNet& net, double t, const AxisReading& reading, int side);

bool is_zero(const Frame& frame);

/// The coordinate axis that a direction is least aligned with.
Vec3<double> least_aligned_axis(const Vec3<double>& d);

/// e_x, e_y, e_z.
Frame coordinate_frame();

/// The separating axes of two oriented boxes (Appendix A (c)), each made when it is asked for:
/// l1, l2, l3 of box 1, l4, l5, l6 of box 2, then l_{3i+j+3} = l_i × l_{j+3}.
/// Safe: any vector is a valid axis, so no rounding here can separate what touches.
class ObbAxes {
 public:
  static constexpr int kCount = 15;
  static constexpr int kStages = 6;  ///< stages are 0..5

  /// length: that of the products of the two frames; the frames have theirs. Where neither shape is
  /// a surface and both frames are zero, the coordinate axes stand in for the first.
  ObbAxes(const std::array<Shape, 2>& shapes, const Frame& frame1, const Frame& frame2,
          AxisReading::Length length);

  /// l_{r+1}, 0 ≤ r < kCount.
  Axis operator[](int r) const;

 private:
  std::array<Frame, 2> frames_;
  AxisReading::Length length_;
};

}  // namespace ccdfuzz
