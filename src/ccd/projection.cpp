#include "ccd/projection.hpp"
#include "numeric/products.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

namespace {

/// (B_cp / P, k_cp) of Appendix A (b), as Appendix A (d) uses them: 2^n and 6n, with 3(n+m) for
/// the 6n of a tensor patch whose degrees differ, and 3n for a curve.
struct Growth {
  double factor;
  int roundings;
};

Growth growth_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return {1, 0};
    case ShapeKind::kCurve:
      return {std::ldexp(1.0, shape.n), 3 * shape.n};
    case ShapeKind::kTriangle:
      return {std::ldexp(1.0, shape.n), 6 * shape.n};
    case ShapeKind::kTensor:
      return {std::ldexp(1.0, std::max(shape.n, shape.m)), 3 * (shape.n + shape.m)};
  }
  return {};
}

}  // namespace

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
  // 3·2^n·B_l·P·[(1+eps)^(k_cp + k_l + 3) − 1]
  const Growth growth = growth_of(shape);
  const double per_unit = ErrorBoundIntended::bound(3 * growth.factor * std::ldexp(1.0, axis.stage),
                                                    growth.roundings + 2 * axis.stage + 3);
  return {per_unit * extent.velocity, per_unit * extent.position};
}

}  // namespace ccdfuzz
