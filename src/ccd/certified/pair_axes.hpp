#pragma once

#include <array>

#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/projection.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz::certified {

inline Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
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
  Axis normal{};
  bool has_normal = false;
  Axis middle{};

  CornerFrame() = default;
  /// The frame of a cell at time t.
  CornerFrame(const CellTree& tree, CellTree::Node node, double t);
  /// The frame of a net, so far from the first to the second time of its snapshot.
  CornerFrame(const Shape& shape, const Snapshot& snapshot, double way);

 private:
  template <class PointAt>
  void build(const Shape& shape, const PointAt& point_at);
};

/// Candidate separating axes of two flat shapes, in batches. For two triangles they are the
/// complete set: both normals, every cross product of edges, every in-plane edge normal. For tensor
/// patches they are its analogue. For curves and points there are also the offset of the middles
/// and its parts across each edge. Those that separate most often come first, and the rest is made
/// only if the first batch leaves the pair together.
class CandidateAxes {
 public:
  /// first: an axis to begin with, if it is not zero. Where cells are to be a distance apart, and
  /// small beside it, the offset of their middles is nearly the direction between nearest points.
  CandidateAxes(const CornerFrame& a, const CornerFrame& b, const Axis& first = {});

  /// Batch i from 0 on; nothing after the last.
  const AxisBatch* batch(int i) {
    if (i > 0 && !complete_) add_rest();
    return i * kLanes < count_ ? &batches_[i] : nullptr;
  }

 private:
  /// Two triangles: 2 normals, 9 cross products, 6 in-plane normals, a first one. All else is
  /// fewer.
  static constexpr int kMost = 18;

  void add(const Axis& l) {
    for (int k = 0; k < 3; ++k) batches_[count_ / kLanes].axes[k][count_ % kLanes] = l[k];
    ++count_;
  }
  void add_rest();

  std::array<AxisBatch, (kMost + kLanes - 1) / kLanes> batches_{};
  const CornerFrame &a_, &b_;
  int count_ = 0;
  bool complete_ = false;
};

}  // namespace ccdfuzz::certified
