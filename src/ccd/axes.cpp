#include "ccd/axes.hpp"
#include "numeric/products.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

namespace {

/// v / |v|, or zero where v is zero or not finite. Scaled first, so that no square leaves the
/// range.
Vec3<double> unit(const Vec3<double>& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(largest > 0) || !std::isfinite(largest)) return {0, 0, 0};
  const Vec3<double> w{v[0] / largest, v[1] / largest, v[2] / largest};
  const double norm = std::sqrt(dot(w, w));
  if (std::isnan(norm)) return {0, 0, 0};  // a NaN is no maximum where it does not come first
  return {w[0] / norm, w[1] / norm, w[2] / norm};
}

Vec3<double> coordinate_axis(int k) {
  Vec3<double> e{0, 0, 0};
  e[k] = 1;
  return e;
}

/// The coordinate axis that a direction is least aligned with.
Vec3<double> least_aligned_axis(const Vec3<double>& d) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(d[k]) < std::abs(d[least])) least = k;
  }
  return coordinate_axis(least);
}

/// The unit direction from the first control point to another at time t.
Vec3<double> span_to(const ControlNet& net, int to, double t) {
  Vec3<double> d;
  for (int k = 0; k < 3; ++k) {
    d[k] = (net.positions[to][k] + t * net.velocities[to][k]) -
           (net.positions[0][k] + t * net.velocities[0][k]);
  }
  return unit(d);
}

}  // namespace

Frame coordinate_frame() {
  return {coordinate_axis(0), coordinate_axis(1), coordinate_axis(2)};
}

Frame obb_frame(const ControlNet& net, double t) {
  const Shape& shape = net.shape;
  Vec3<double> u{0, 0, 0}, v{0, 0, 0};
  switch (shape.kind) {
    case ShapeKind::kPoint:
      break;
    case ShapeKind::kCurve:
      u = span_to(net, shape.n, t);
      v = least_aligned_axis(u);
      break;
    case ShapeKind::kTriangle:
      u = span_to(net, shape.index(shape.n, 0), t);
      v = span_to(net, shape.index(0, shape.n), t);
      break;
    case ShapeKind::kTensor:
      u = span_to(net, shape.index(shape.n, 0), t);
      v = span_to(net, shape.index(0, shape.m), t);
      break;
  }
  const Vec3<double> normal = unit(cross(u, v));
  return {u, normal, unit(cross(u, normal))};
}

bool is_zero(const Frame& frame) {
  return std::all_of(frame.begin(), frame.end(), [](const auto& l) { return Axis{l}.is_zero(); });
}

ObbAxes ObbAxes::of(const std::array<Shape, 2>& shapes, const Frame& frame1, const Frame& frame2) {
  const bool surface = shapes[0].parameter_count() == 2 || shapes[1].parameter_count() == 2;
  if (!surface && ccdfuzz::is_zero(frame1) && ccdfuzz::is_zero(frame2)) {
    return {coordinate_frame(), frame2};
  }
  return {frame1, frame2};
}

Axis ObbAxes::operator[](int r) const {
  if (r < 6) return {frames_[r / 3][r % 3], r % 3};
  const int i = (r - 6) / 3, j = (r - 6) % 3;
  return {unit(cross(frames_[0][i], frames_[1][j])), i + j + 1};
}

}  // namespace ccdfuzz
