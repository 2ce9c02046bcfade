#include "ccd/certified/pair_axes.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz::certified {

CornerFrame::CornerFrame(const CellTree& tree, CellTree::Node node, double t) {
  const double* net = tree.net(node);
  build(tree.shape(), [&](int i) {
    const double* x = net + kPerPoint * i;
    Axis p{x[0] + t * x[4], x[1] + t * x[5], x[2] + t * x[6]};
    if (const double weight = x[kWeightPlace]; weight != 0) {
      for (double& coordinate : p) coordinate /= weight;
    }
    return p;
  });
}

CornerFrame::CornerFrame(const Shape& shape, const Snapshot& snapshot, double way) {
  build(shape, [&](int i) {
    Axis p;
    for (int k = 0; k < 3; ++k) {
      p[k] = (1 - way) * snapshot.at(0, k, i) + way * snapshot.at(1, k, i);
    }
    return p;
  });
}

template <class PointAt>
void CornerFrame::build(const Shape& shape, const PointAt& at) {
  const Axis origin = at(0);
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      middle = origin;
      return;
    case ShapeKind::kCurve: {
      const Axis end = at(shape.n);
      edges[0] = minus(end, origin);
      edge_count = 1;
      for (int k = 0; k < 3; ++k) middle[k] = 0.5 * (origin[k] + end[k]);
      return;
    }
    case ShapeKind::kTriangle: {
      const Axis u = at(shape.index(shape.n, 0)), v = at(shape.index(0, shape.n));
      edges = {minus(u, origin), minus(v, origin), minus(v, u)};
      edge_count = 3;
      for (int k = 0; k < 3; ++k) middle[k] = (origin[k] + u[k] + v[k]) / 3;
      break;
    }
    case ShapeKind::kTensor: {
      const Axis u = at(shape.index(shape.n, 0)), v = at(shape.index(0, shape.m));
      const Axis uv = at(shape.index(shape.n, shape.m));
      edges[0] = plus(minus(u, origin), minus(uv, v));
      edges[1] = plus(minus(v, origin), minus(uv, u));
      edge_count = 2;
      for (int k = 0; k < 3; ++k) middle[k] = 0.25 * ((origin[k] + u[k]) + (v[k] + uv[k]));
      break;
    }
  }
  normal = cross(edges[0], edges[1]);
  has_normal = true;
}

CandidateAxes::CandidateAxes(const CornerFrame& a, const CornerFrame& b, const Axis& first)
    : a_(a), b_(b) {
  if (first != Axis{}) add(first);
  if (a.has_normal) add(a.normal);
  if (b.has_normal) add(b.normal);
  if (a.edge_count > 0 && b.edge_count > 0) add(cross(a.edges[0], b.edges[0]));
  if (a.has_normal) add(cross(a.normal, a.edges[0]));
  if (count_ < kLanes) add_rest();
}

void CandidateAxes::add_rest() {
  complete_ = true;
  for (int i = 0; i < a_.edge_count; ++i) {
    for (int j = 0; j < b_.edge_count; ++j) {
      if (i + j > 0) add(cross(a_.edges[i], b_.edges[j]));
    }
  }
  for (const CornerFrame* s : {&a_, &b_}) {
    if (!s->has_normal) continue;
    for (int i = s == &a_ ? 1 : 0; i < s->edge_count; ++i) add(cross(s->normal, s->edges[i]));
  }
  if (a_.has_normal && b_.has_normal) return;
  const Axis offset = minus(a_.middle, b_.middle);
  add(offset);
  for (const CornerFrame* s : {&a_, &b_}) {
    for (int i = 0; i < s->edge_count; ++i) add(cross(s->edges[i], cross(offset, s->edges[i])));
  }
}

}  // namespace ccdfuzz::certified
