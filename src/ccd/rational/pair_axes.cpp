#include "ccd/rational/pair_axes.hpp"
#include "ccd/axes.hpp"
#include "numeric/products.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ccdfuzz::exact_ccd {

namespace {

/// v over its largest component; zero if that is zero or the quotient overflows.
Vec3<double> normalised(const Vec3<double>& v) {
  const double m = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(m > 0)) return {0, 0, 0};
  return {v[0] / m, v[1] / m, v[2] / m};
}

/// Control point i at t.
certified::Axis point_at(const CellPoints& points, double t, int i) {
  certified::Axis p;
  for (int k = 0; k < 3; ++k) p[k] = points.position(k)[i] + t * points.velocity(k)[i];
  return p;
}

certified::CornerFrame corner_frame(const Shape& shape, const CellPoints& points, double t) {
  return {shape, [&](int i) { return point_at(points, t, i); }};
}

/// Two directions that the cell spans at t; zero where it spans fewer.
std::array<Vec3<double>, 2> spanned(const Shape& shape, const CellPoints& points, double t) {
  const auto from_start = [&](int i) {
    const certified::Axis p = point_at(points, t, 0), q = point_at(points, t, i);
    return normalised({q[0] - p[0], q[1] - p[1], q[2] - p[2]});
  };
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  // A curve spans its chord, and the way from its start to the middle control point.
  const bool is_curve = shape.kind == ShapeKind::kCurve;
  const int v_end = is_curve ? (shape.n + 1) / 2 : shape.index(0, shape.last_column(0));
  return {from_start(shape.index(shape.n, 0)), from_start(v_end)};
}

}  // namespace

BoxDirections box_directions(const Shape& shape, const CellPoints& points, double t) {
  auto [u, v] = spanned(shape, points, t);
  if (u == Vec3<double>(0, 0, 0)) std::swap(u, v);
  if (u == Vec3<double>(0, 0, 0)) return coordinate_frame();
  Vec3<double> normal = normalised(cross(u, v));
  if (normal == Vec3<double>(0, 0, 0)) normal = normalised(cross(u, least_aligned_axis(u)));
  return {u, normal, normalised(cross(u, normal))};
}

Vec3<double> pair_axis(const BoxDirections& a, const BoxDirections& b, int r) {
  constexpr std::array<size_t, 3> kOrder = {1, 0, 2};
  if (r < 6) return (r % 2 == 0 ? a : b)[kOrder[static_cast<size_t>(r / 2)]];
  return cross(a[static_cast<size_t>((r - 6) / 3)], b[static_cast<size_t>((r - 6) % 3)]);
}

certified::CandidateAxes axes_apart(const std::array<Shape, 2>& shapes, const CellPoints& a,
                                    const CellPoints& b, double t) {
  return {corner_frame(shapes[0], a, t), corner_frame(shapes[1], b, t), true};
}

}  // namespace ccdfuzz::exact_ccd
