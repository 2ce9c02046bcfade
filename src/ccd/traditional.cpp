#include "ccd/traditional.hpp"
#include "numeric/products.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ccdfuzz {

namespace {

/// The range of points on an axis.
std::array<double, 2> range_on(const Vec3<double>& axis, std::span<const Vec3<double>> points) {
  std::array<double, 2> range = {dot(axis, points[0]), dot(axis, points[0])};
  for (const Vec3<double>& p : points.subspan(1)) {
    const double height = dot(axis, p);
    range = {std::min(range[0], height), std::max(range[1], height)};
  }
  return range;
}

/// What an axis on which the two parts range like this says of a window.
void tell(ExclusionObserver& observer, int axis, const Vec3<double>& direction,
          const std::array<std::array<double, 2>, 2>& ranges, const Window& window) {
  if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0) return;
  for (int below = 0; below < 2; ++below) {
    const double top = ranges[below][1], bottom = ranges[1 - below][0];
    const double height = std::max(std::abs(top), std::abs(bottom)), gap = top - bottom;
    const double ulp = std::nextafter(height, std::numeric_limits<double>::infinity()) - height;
    observer.compared({axis, direction, below, window, gap, gap, ulp});
    if (top < bottom) {
      observer.excluded({axis, direction, below, {window.lo, window.hi, true, true}});
    }
  }
}

/// The control points of a part at both ends of the window.
void sweep(const ControlNet& net, const Window& window, Points<double>& out) {
  out.clear();
  for (const double t : {window.lo, window.hi}) {
    for (size_t i = 0; i < net.positions.size(); ++i) {
      const Vec3<double>&p = net.positions[i], &v = net.velocities[i];
      out.emplace_back(p[0] + t * v[0], p[1] + t * v[1], p[2] + t * v[2]);
    }
  }
}

}  // namespace

std::optional<Window> TraditionalInclusion::test(int part_a, int part_b, const Window& window,
                                                 ExclusionObserver* observer) {
  const std::array<ControlNet, 2> nets = {parts_.net(0, part_a), parts_.net(1, part_b)};
  for (int side = 0; side < 2; ++side) sweep(nets[side], window, sweeps_[side]);
  const auto separates = [&](int r, const Vec3<double>& axis) {  // Eqs. 3a, 3b negated
    const auto p = range_on(axis, sweeps_[0]), q = range_on(axis, sweeps_[1]);
    if (observer != nullptr) tell(*observer, r, axis, {p, q}, window);
    return p[1] < q[0] || q[1] < p[0];
  };
  if (kind_ == BoxKind::kAxisAligned) {
    const Frame axes = coordinate_frame();
    for (int r = 0; r < 3; ++r) {
      if (separates(r, axes[static_cast<size_t>(r)])) return std::nullopt;
    }
    return window;
  }
  const ObbAxes axes = parts_.axes(part_a, part_b, window.lo);
  for (int r = 0; r < ObbAxes::kCount; ++r) {
    if (separates(r, axes[r].direction)) return std::nullopt;  // a zero axis never does
  }
  return window;
}

}  // namespace ccdfuzz
