#include "bezier/trim_region.hpp"

#include <span>

#include "bezier/orientation.hpp"

namespace ccdfuzz {

namespace {

/// A closed cell as a convex polygon.
struct CellPolygon {
  std::array<Uv<double>, 4> vertices;
  size_t count;
  Uv<double> lo, hi;  ///< its bounding box

  CellPolygon(const Cell& cell, const Shape& shape) {
    const std::array<Uv<double>, 3> c = cell.corners(shape);
    if (shape.kind == ShapeKind::kTensor) {
      lo = c[0], hi = c[1], count = 4;
      vertices = {lo, {hi[0], lo[1]}, hi, {lo[0], hi[1]}};
      return;
    }
    // c[1] and c[2] are opposite corners of the box, and ends of the diagonal.
    vertices = {c[0], c[1], c[2], {}}, count = 3;
    lo = cell.inverted ? Uv<double>{c[1][0], c[2][1]} : c[0];
    hi = cell.inverted ? c[0] : Uv<double>{c[1][0], c[2][1]};
  }

  std::span<const Uv<double>> points() const { return std::span(vertices).first(count); }
};

/// True iff the closed segment meets the closed cell. If not, the line of a side of the cell, or
/// that of the segment, has one of them strictly on one side of it.
bool meets(const Uv<double>& a, const Uv<double>& b, const CellPolygon& cell) {
  for (const size_t k : {size_t{0}, size_t{1}}) {
    if (compare(a[k], cell.lo[k]) < 0 && compare(b[k], cell.lo[k]) < 0) return false;
    if (compare(a[k], cell.hi[k]) > 0 && compare(b[k], cell.hi[k]) > 0) return false;
  }
  const std::span<const Uv<double>> points = cell.points();
  if (points.size() == 3) {
    const int inside = orientation(points[1], points[2], points[0]);
    const auto beyond = [&](const Uv<double>& p) {
      return orientation(points[1], points[2], p) == -inside;
    };
    if (beyond(a) && beyond(b)) return false;
  }
  const int side = orientation(a, b, points[0]);
  if (side == 0) return true;
  for (const Uv<double>& p : points.subspan(1)) {
    if (orientation(a, b, p) != side) return true;
  }
  return false;
}

}  // namespace

void TrimRegion::assign(const MovingPatch<double>& patch) {
  shape_ = patch.shape;
  edges_.clear();
  for (const auto& loop : patch.trim) {
    for (size_t i = 0; i < loop.size(); ++i)
      edges_.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }
}

TrimRegion::Cover TrimRegion::cover(const Cell& cell) const {
  if (is_whole()) return Cover::kInside;
  const CellPolygon polygon(cell, shape_);
  for (const Edge& edge : edges_) {
    if (meets(edge.from, edge.to, polygon)) return Cover::kCrossed;
  }
  return is_inside(polygon.vertices[0]) ? Cover::kInside : Cover::kOutside;
}

TrimRegion::Children TrimRegion::children(const Cell& parent) const {
  Children out;
  for (int c = 0; c < shape_.child_count(); ++c) {
    const Cover covered = cover(parent.child(shape_, c));
    if (covered == Cover::kOutside) out.outside |= 1U << c;
    if (covered == Cover::kCrossed) out.crossed |= 1U << c;
  }
  return out;
}

bool TrimRegion::is_inside(const Uv<double>& p) const {
  bool odd = false;
  for (const Edge& edge : edges_) odd ^= crosses_ray(p, edge.from, edge.to);
  return odd;
}

bool TrimRegion::contains(const Uv<double>& uv) const {
  if (is_whole()) return true;
  for (const Edge& edge : edges_) {
    if (is_on_segment(uv, edge.from, edge.to)) return true;
  }
  return is_inside(uv);
}

}  // namespace ccdfuzz
