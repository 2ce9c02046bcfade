#pragma once

#include <array>

#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/projection.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz::certified {

inline Axis minus(const Axis& a, const Axis& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Axis plus(const Axis& a, const Axis& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The flat shape nearest to a net at one time: what the candidate axes are made from. Any vector
/// is a valid axis and taken as exact as computed, so nothing here needs an error bound.
struct CornerFrame {
  std::array<Axis, 3> edges{};
  int edge_count = 0;
  Axis normal{};  ///< of two edges or more
  Axis middle{};

  bool has_normal() const { return edge_count > 1; }

  /// The frame of control points: point_at(i) is point i, in Shape's order.
  template <class PointAt>
  CornerFrame(const Shape& shape, const PointAt& point_at);
  /// The frame of a cell at time t.
  CornerFrame(const CellTree& tree, CellTree::Node node, double t);
  /// The frame of a net, so far from the first to the second time of its snapshot.
  CornerFrame(const Shape& shape, const Snapshot& snapshot, double way);
};

template <class PointAt>
CornerFrame::CornerFrame(const Shape& shape, const PointAt& point_at) {
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  const Axis origin = point_at(0);
  if (shape.kind == ShapeKind::kPoint) {
    middle = origin;
    return;
  }
  const Axis u = point_at(shape.index(shape.n, 0));
  if (shape.kind == ShapeKind::kCurve) {
    edge_count = 1;
    edges[0] = minus(u, origin);
    for (int k = 0; k < 3; ++k) middle[k] = 0.5 * (origin[k] + u[k]);
    return;
  }
  const Axis v = point_at(shape.index(0, shape.last_column(0)));
  if (shape.kind == ShapeKind::kTriangle) {
    edge_count = 3;
    edges = {minus(u, origin), minus(v, origin), minus(v, u)};
    for (int k = 0; k < 3; ++k) middle[k] = (origin[k] + u[k] + v[k]) / 3;
  } else {
    const Axis uv = point_at(shape.index(shape.n, shape.m));
    edge_count = 2;
    edges[0] = plus(minus(u, origin), minus(uv, v));
    edges[1] = plus(minus(v, origin), minus(uv, u));
    for (int k = 0; k < 3; ++k) middle[k] = 0.25 * ((origin[k] + u[k]) + (v[k] + uv[k]));
  }
  normal = cross(edges[0], edges[1]);
}

/// Candidate separating axes of two flat shapes, in batches. For two triangles they are the
/// complete set: both normals, every cross product of edges, every in-plane edge normal. For tensor
/// patches they are its analogue. For curves and points there are also the offset of the middles
/// and its parts across each edge. Those that separate most often come first, and the rest is made
/// only if the first batch leaves the pair together.
class CandidateAxes {
 public:
  /// apart: the shapes are to be a distance apart. Where they are small beside it, the offset of
  /// their middles is nearly the direction between nearest points, and comes first.
  CandidateAxes(const CornerFrame& a, const CornerFrame& b, bool apart);

  /// Two triangles: 2 normals, 9 cross products, 6 in-plane normals, a first one. All else is
  /// fewer.
  static constexpr int kMost = 18;

  /// Batch i from 0 on; nothing after the last.
  const AxisBatch* batch(int i) {
    if (i > 0 && !complete_) add_rest();
    return i * kLanes < count_ ? &batches_[i] : nullptr;
  }
  /// Axis r, 0 ≤ r < kMost; zero from the last on.
  Axis operator[](int r) {
    const AxisBatch* const of_r = batch(r / kLanes);
    return of_r != nullptr ? axis_of(*of_r, r % kLanes) : Axis{};
  }

 private:
  void add(const Axis& l) {
    for (int k = 0; k < 3; ++k) batches_[count_ / kLanes].axes[k][count_ % kLanes] = l[k];
    ++count_;
  }
  void add_rest();

  std::array<AxisBatch, (kMost + kLanes - 1) / kLanes> batches_{};
  const CornerFrame a_, b_;
  const bool apart_;
  int count_ = 0;
  bool complete_ = false;
};

}  // namespace ccdfuzz::certified
