#include "ccd/axes.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/products.hpp"

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

struct Spans {
  Vec3<double> u{0, 0, 0};
  Vec3<double> v{0, 0, 0};  ///< zero unless a surface's
};

/// at: a control point by its place.
template <class At>
Spans spans_of(const Shape& shape, bool over_both_sides, const At& at) {
  const auto from_to = [&at](int from, int to) { return Vec3<double>(at(to) - at(from)); };
  const int u_end = shape.index(shape.n, 0), v_end = shape.index(0, shape.last_column(0));
  Spans spans;
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  if (shape.parameter_count() > 0) spans.u = from_to(0, u_end);
  if (shape.parameter_count() > 1) spans.v = from_to(0, v_end);
  if (shape.kind == ShapeKind::kTensor && over_both_sides) {
    const int far = shape.index(shape.n, shape.m);
    spans.u = (spans.u + at(far)) - at(v_end);
    spans.v = (spans.v + at(far)) - at(u_end);
  }
  return spans;
}

/// The spans of patch `side`, 0 or 1, at time t.
Spans spans_at(const ControlNet& net, double t, AxisReading::Spans reading, int side) {
  using Reading = AxisReading::Spans;
  if (reading == Reading::kCorners || reading == Reading::kMovedSides) {
    return spans_of(net.shape, reading == Reading::kMovedSides, [&](int i) {
      return Vec3<double>(net.positions[static_cast<size_t>(i)] +
                          t * net.velocities[static_cast<size_t>(i)]);
    });
  }
  const auto of = [&net](std::span<const Vec3<double>> points) {
    return spans_of(net.shape, true, [points](int i) -> const Vec3<double>& {
      return points[static_cast<size_t>(i)];
    });
  };
  const Spans start = of(net.positions), speed = of(net.velocities);
  const bool slips = reading == Reading::kSidesWithSlip && side == 1;
  return {start.u + t * speed.u, start.v + t * (slips ? speed.u : speed.v)};
}

}  // namespace

Vec3<double> least_aligned_axis(const Vec3<double>& d) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(d[k]) < std::abs(d[least])) least = k;
  }
  return Vec3<double>::Unit(least);
}

Frame coordinate_frame() {
  return {Vec3<double>::Unit(0), Vec3<double>::Unit(1), Vec3<double>::Unit(2)};
}

Frame obb_frame(const ControlNet& net, double t, const AxisReading& reading, int side) {
  const auto product = [&](const Vec3<double>& a, const Vec3<double>& b) {
    return reading.length == AxisReading::Length::kUnit ? unit(cross(a, b)) : cross(a, b);
  };
  auto [u, v] = spans_at(net, t, reading.spans, side);
  if (reading.length != AxisReading::Length::kAsTheyAre) u = unit(u), v = unit(v);
  if (net.shape.kind == ShapeKind::kCurve) v = least_aligned_axis(u);
  const Vec3<double> normal = product(u, v);
  return {u, normal, product(u, normal)};
}

bool is_zero(const Frame& frame) {
  return std::all_of(frame.begin(), frame.end(), [](const auto& l) { return Axis{l}.is_zero(); });
}

ObbAxes::ObbAxes(const std::array<Shape, 2>& shapes, const Frame& frame1, const Frame& frame2,
                 AxisReading::Length length)
    : frames_{frame1, frame2}, length_(length) {
  const bool surface = shapes[0].parameter_count() == 2 || shapes[1].parameter_count() == 2;
  if (!surface && is_zero(frame1) && is_zero(frame2)) frames_[0] = coordinate_frame();
}

Axis ObbAxes::operator[](int r) const {
  if (r < 6) return {frames_[r / 3][r % 3], r % 3};
  const int i = (r - 6) / 3, j = (r - 6) % 3;
  const Vec3<double> l = cross(frames_[0][i], frames_[1][j]);
  return {length_ == AxisReading::Length::kUnit ? unit(l) : l, i + j + 1};
}

}  // namespace ccdfuzz
