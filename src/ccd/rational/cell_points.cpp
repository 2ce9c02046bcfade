#include "ccd/rational/cell_points.hpp"

#include <algorithm>

#include "base/verify.hpp"
#include "bezier/restrict.hpp"

namespace ccdfuzz::exact_ccd {

namespace {

/// Largest family: the four children of a triangle or tensor patch.
constexpr size_t kFamily = 4;

}  // namespace

void CellPointsCache::begin(const Shape& shape, const Points<double>& positions,
                            const Points<double>& velocities, const std::vector<double>& weights) {
  if (!program_ || !(shape == shape_)) program_.emplace(shape);
  shape_ = shape;
  positions_ = positions;
  velocities_ = velocities;
  weights_ = as_points<double>(weights);
  multiply(positions_, weights);
  multiply(velocities_, weights);
  part_.resize(positions.size());
  controls_.resize(positions.size() + program_->steps.size());
  slots_.fill({});
  points_.resize(kSlots * kFamily * 6 * positions.size());
}

int CellPointsCache::roundings(const Shape& shape, bool is_rational) {
  // From scratch, a blossom step sums three products for a triangle and two else. The averages of
  // the midpoint split round once each, one for every argument of the blossom.
  const int steps = shape.n + shape.m;
  const int of_polynomial = (shape.kind == ShapeKind::kTriangle ? 3 : 2) * steps + steps;
  // Those of numerator and weight, the product with the weight and the quotient.
  return is_rational ? 2 * of_polynomial + 2 : of_polynomial;
}

CellPoints CellPointsCache::family(std::span<const Cell> parts) {
  const size_t index = hash_of(parts[0]) % kSlots;
  double* data = points_.data() + index * kFamily * 6 * part_.size();
  Slot& slot = slots_[index];
  if (slot.size != parts.size() || !(slot.first == parts[0])) {
    fill(parts, data);
    slot = {parts[0], parts.size()};
  }
  return {data, shape_.control_count()};
}

/// Writes the six arrays of a cell whose control point i is controls_[place(i)].
template <class Place>
void CellPointsCache::store(const Place& place, double* out) const {
  const int count = shape_.control_count();
  for (int i = 0; i < count; ++i) {
    const Control& c = controls_[static_cast<size_t>(place(i))];
    for (int k = 0; k < 6; ++k) {
      const double number = c[static_cast<size_t>(k)];
      out[k * count + i] = weights_.empty() ? number : number / c[6];
    }
  }
}

void CellPointsCache::fill(std::span<const Cell> parts, double* out) {
  const bool root = parts[0].depth == 0;
  CCDFUZZ_ASSERT(root || parts.size() == program_->children.size());
  // Child 0 of a cell has its orientation, at twice its place or, if inverted, one higher.
  const Cell& first = parts[0];
  const Cell parent =
      root ? first : Cell{first.i / 2, first.j / 2, first.depth - 1, first.inverted};
  CCDFUZZ_ASSERT(root || parent.child(shape_, 0) == first);

  const std::array<Uv<double>, 3> corners = parent.corners(shape_);
  const std::array<const Points<double>*, 3> nets = {&positions_, &velocities_, &weights_};
  const size_t numbers = weights_.empty() ? 6 : 7;
  for (size_t from = 0; from < numbers; from += 3) {
    restrict_to<double>(shape_, *nets[from / 3], corners, part_);
    for (size_t i = 0; i < part_.size(); ++i) {
      for (size_t k = from; k < std::min(from + 3, numbers); ++k)
        controls_[i][k] = part_[i][static_cast<Eigen::Index>(k - from)];
    }
  }
  if (root) return store([](int i) { return i; }, out);

  Control* next = &controls_[part_.size()];
  for (const auto& [left, right] : program_->steps) {
    const Control &l = controls_[static_cast<size_t>(left)],
                  &r = controls_[static_cast<size_t>(right)];
    for (size_t k = 0; k < numbers; ++k) (*next)[k] = 0.5 * (l[k] + r[k]);
    ++next;
  }
  for (const std::vector<int>& places : program_->children) {
    store([&](int i) { return places[static_cast<size_t>(i)]; }, out);
    out += 6 * part_.size();
  }
}

}  // namespace ccdfuzz::exact_ccd
