#include "ccd/rational/cell_points.hpp"

#include "bezier/restrict.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// Largest family: the four children of a triangle or tensor patch.
constexpr size_t kFamily = 4;

size_t hash(const Cell& cell) {
  std::uint64_t h = cell.i * 0x9e3779b97f4a7c15ULL ^ cell.j * 0xc2b2ae3d27d4eb4fULL;
  h += static_cast<std::uint64_t>(cell.depth) * 2 + (cell.inverted ? 1 : 0);
  h ^= h >> 32;
  return static_cast<size_t>(h * 0x9e3779b97f4a7c15ULL >> 40);
}

}  // namespace

void CellPointsCache::begin(const Shape& shape, const Points<double>& positions,
                            const Points<double>& velocities) {
  shape_ = shape;
  positions_ = positions;
  velocities_ = velocities;
  part_.resize(positions.size());
  slots_.fill({});
  points_.resize(kSlots * kFamily * 6 * positions.size());
}

CellPoints CellPointsCache::family(std::span<const Cell> parts) {
  const size_t index = hash(parts[0]) % kSlots;
  const size_t count = positions_.size();
  double* data = points_.data() + index * kFamily * 6 * count;
  Slot& slot = slots_[index];
  if (slot.size != parts.size() || !(slot.first == parts[0])) {
    fill(parts, data);
    slot = {parts[0], parts.size()};
  }
  return {data, static_cast<int>(count)};
}

void CellPointsCache::fill(std::span<const Cell> parts, double* out) {
  for (const Cell& cell : parts) {
    const std::array<Uv<double>, 3> corners = cell.corners(shape_);
    for (const Points<double>* points : {&positions_, &velocities_}) {
      restrict_to<double>(shape_, *points, corners, part_);
      for (Eigen::Index k = 0; k < 3; ++k) {
        for (const Vec3<double>& p : part_) *out++ = p[k];
      }
    }
  }
}

}  // namespace ccdfuzz::exact_ccd
