#include "ccd/sub_patches.hpp"

#include <limits>

#include "bezier/restrict.hpp"

namespace ccdfuzz {

void SubPatches::begin(const Query& query) {
  query_ = &query;
  for (size_t side = 0; side < 2; ++side) {
    const MovingPatch<double>& patch = query.patches[side];
    kept_[side].parts.fill(0);
    kept_[side].points.resize(kSplits * static_cast<size_t>(4 * 2 * patch.shape.control_count()));
    if (!patch.is_rational()) continue;
    Homogeneous& h = homogeneous_[side];
    h.positions = patch.positions;
    h.velocities = patch.velocities;
    const std::vector<double> weights = scaled_weights(patch);
    multiply(h.positions, weights);
    multiply(h.velocities, weights);
    h.weights = h.new_weights = as_points<double>(weights);
  }
}

void SubPatches::prepare(int side, std::span<const Cell> parts) {
  const MovingPatch<double>& patch = query_->patches[side];
  const auto count = static_cast<size_t>(patch.shape.control_count());
  Families& kept = kept_[side];
  const size_t place = hash_of(parts[0]) % kSplits;
  const bool is_rational = patch.is_rational();
  Homogeneous& h = homogeneous_[static_cast<size_t>(side)];
  const Points<double>& positions = is_rational ? h.positions : patch.positions;
  const Points<double>& velocities = is_rational ? h.velocities : patch.velocities;
  const bool known = kept.parts[place] >= parts.size() && kept.first[place] == parts[0];
  for (size_t c = 0; c < parts.size(); ++c) {
    Vec3<double>* points = &kept.points[(place * 4 + c) * 2 * count];
    if (!known) {
      const auto corners = parts[c].corners(patch.shape);
      restrict_to<double>(patch.shape, positions, corners, {points, count});
      restrict_to<double>(patch.shape, velocities, corners, {points + count, count});
      if (is_rational) restrict_to<double>(patch.shape, h.weights, corners, h.new_weights);
      for (size_t i = 0; is_rational && i < count; ++i) {
        divide(points[i], h.new_weights[i][0]);
        divide(points[count + i], h.new_weights[i][0]);
      }
    }
    parts_[side][c].points = points;
    parts_[side][c].frame_time = std::numeric_limits<double>::quiet_NaN();
  }
  if (known) return;
  kept.first[place] = parts[0];
  kept.parts[place] = parts.size();
}

const Frame& SubPatches::frame(int side, int part, double t) {
  Part& p = parts_[side][part];
  if (p.frame_time != t) {
    p.frame = obb_frame(net(side, part), t, reading_, side);
    p.frame_time = t;
  }
  return p.frame;
}

ObbAxes SubPatches::axes(int part_a, int part_b, double t) {
  return ObbAxes({query_->patches[0].shape, query_->patches[1].shape}, frame(0, part_a, t),
                 frame(1, part_b, t), reading_.length);
}

}  // namespace ccdfuzz
