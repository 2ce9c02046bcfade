#include "ccd/sub_patches.hpp"

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
  }
}

}  // namespace ccdfuzz
