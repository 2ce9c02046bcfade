#include "ccd/projection.hpp"
#include "numeric/products.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

double largest_component(const Points<double>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) largest = std::max(largest, std::abs(p[k]));
  }
  return largest;
}

void project(const ControlNet& net, const Axis& axis, Lines<double>& out) {
  out.clear();
  for (size_t i = 0; i < net.positions.size(); ++i) {
    out.push_back({dot(axis.direction, net.velocities[i]), dot(axis.direction, net.positions[i])});
  }
  sort_lines(out);
}

LargestComponents largest_components_of(const MovingPatch<double>& patch) {
  return {largest_component(patch.positions), largest_component(patch.velocities)};
}

CoefficientError coefficient_error(const Shape& shape, const LargestComponents& extent,
                                   const Axis& axis) {
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  // 3·B_cp·B_l·[(1+eps)^(k_cp + k_l + 3) − 1]. It takes B_cp = 2^n·P and k_cp = 6n of (b), with
  // 3(n+m) for the 6n of a tensor patch whose degrees differ, and 3n for a curve. With weights
  // 2·k_cp + 2 stands for k_cp: k_cp + 1 behind w·p, k_cp behind w > 0, and the quotient's. The
  // factor 2 of Appendix B covers it: 2(k_cp + k_l + 3) > (2·k_cp + 2) + k_l + 3.
  const double factor = std::ldexp(1.0, std::max(shape.n, shape.m));
  const int steps = shape.kind == ShapeKind::kTriangle ? 2 * shape.n : shape.n + shape.m;
  const double per_unit = ErrorBoundIntended::bound(3 * factor * std::ldexp(1.0, axis.stage),
                                                    3 * steps + 2 * axis.stage + 3);
  return {per_unit * extent.velocity, per_unit * extent.position};
}

}  // namespace ccdfuzz
