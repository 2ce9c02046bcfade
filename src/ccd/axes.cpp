#include "ccd/axes.hpp"

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
  return {w[0] / norm, w[1] / norm, w[2] / norm};
}

bool is_zero(const Vec3<double>& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

Vec3<double> coordinate_axis(int k) {
  Vec3<double> e{0, 0, 0};
  e[k] = 1;
  return e;
}

/// The unit direction from one control point to another at time t.
Vec3<double> span_of(const ControlNet& net, int from, int to, double t) {
  Vec3<double> d;
  for (int k = 0; k < 3; ++k) {
    d[k] = (net.positions[to][k] + t * net.velocities[to][k]) -
           (net.positions[from][k] + t * net.velocities[from][k]);
  }
  return unit(d);
}

/// A box's own axes l1, l2, l3; zero where there are none.
std::array<Vec3<double>, 3> frame_of(const ControlNet& net, double t) {
  const Shape& shape = net.shape;
  Vec3<double> u{0, 0, 0}, v{0, 0, 0};
  switch (shape.kind) {
    case ShapeKind::kPoint:
      break;
    case ShapeKind::kCurve: {
      u = span_of(net, 0, shape.n, t);
      int least = 0;
      for (int k = 1; k < 3; ++k) {
        if (std::abs(u[k]) < std::abs(u[least])) least = k;
      }
      v = coordinate_axis(least);
      break;
    }
    case ShapeKind::kTriangle:
      u = span_of(net, 0, shape.index(shape.n, 0), t);
      v = span_of(net, 0, shape.index(0, shape.n), t);
      break;
    case ShapeKind::kTensor:
      u = span_of(net, 0, shape.index(shape.n, 0), t);
      v = span_of(net, 0, shape.index(0, shape.m), t);
      break;
  }
  const Vec3<double> normal = unit(cross(u, v));
  return {u, normal, unit(cross(u, normal))};
}

bool is_surface(const Shape& shape) {
  return shape.parameter_count() == 2;
}

}  // namespace

void Axes::add(const Vec3<double>& v, int stage) {
  const Vec3<double> direction = unit(v);
  if (!is_zero(direction)) axes_[size_++] = {direction, stage};
}

Axes aabb_axes() {
  Axes axes;
  for (int k = 0; k < 3; ++k) axes.add(coordinate_axis(k), 0);
  return axes;
}

Axes obb_axes(const ControlNet& patch1, const ControlNet& patch2, double t) {
  Axes axes;
  const std::array<std::array<Vec3<double>, 3>, 2> frames = {frame_of(patch1, t),
                                                             frame_of(patch2, t)};
  for (const std::array<Vec3<double>, 3>& frame : frames) {
    for (int i = 0; i < 3; ++i) axes.add(frame[i], i);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) axes.add(cross(frames[0][i], frames[1][j]), i + j + 1);
  }
  const bool paper_covers_it = is_surface(patch1.shape) || is_surface(patch2.shape);
  return axes.size() == 0 && !paper_covers_it ? aabb_axes() : axes;
}

}  // namespace ccdfuzz
