#include "ccd/certified/pair_axes.hpp"

namespace ccdfuzz::certified {

Skeleton::Skeleton(const CellTree& tree, CellTree::Node node, double t) {
  const double* net = tree.net(node);
  const int width = tree.width();
  const Shape& shape = tree.shape();
  const auto at = [&](int i) {
    Axis p;
    for (int k = 0; k < 3; ++k) p[k] = net[k * width + i] + t * net[(k + 3) * width + i];
    return p;
  };
  const Axis origin = at(0);
  switch (shape.kind) {
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

}  // namespace ccdfuzz::certified
