#include "ccd/sub_patches.hpp"

#include <limits>

#include "bezier/restrict.hpp"

namespace ccdfuzz {

void SubPatches::prepare(int side, std::span<const Cell> parts) {
  const MovingPatch<double>& patch = query_->patches[side];
  const auto count = static_cast<size_t>(patch.shape.control_count());
  for (size_t c = 0; c < parts.size(); ++c) {
    Part& part = parts_[side][c];
    const auto corners = parts[c].corners(patch.shape);
    restrict_to<double>(patch.shape, patch.positions, corners, {part.positions.data(), count});
    restrict_to<double>(patch.shape, patch.velocities, corners, {part.velocities.data(), count});
    part.frame_time = std::numeric_limits<double>::quiet_NaN();
  }
}

const Frame& SubPatches::frame(int side, int part, double t) {
  Part& p = parts_[side][part];
  if (p.frame_time != t) {
    p.frame = obb_frame(net(side, part), t);
    p.frame_time = t;
  }
  return p.frame;
}

ObbAxes SubPatches::axes(int part_a, int part_b, double t) {
  const Frame &frame1 = frame(0, part_a, t), &frame2 = frame(1, part_b, t);
  const auto is_surface = [this](int side) {
    return query_->patches[side].shape.parameter_count() == 2;
  };
  if (!is_surface(0) && !is_surface(1) && is_zero(frame1) && is_zero(frame2)) {
    return {coordinate_frame(), frame2};
  }
  return {frame1, frame2};
}

}  // namespace ccdfuzz
