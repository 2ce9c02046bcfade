#pragma once

#include <array>

#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/projection.hpp"

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
struct Skeleton {
  std::array<Axis, 3> edges{};
  int edge_count = 0;
  Axis normal{};
  bool has_normal = false;
  Axis middle{};

  Skeleton() = default;
  Skeleton(const CellTree& tree, CellTree::Node node, double t);
};

/// Candidate separating axes of two flat shapes: the complete set for two triangles (both normals,
/// every cross product of edges, every in-plane edge normal), its analogue for tensor patches, and
/// for curves and points also the offset of the middles and its parts across each edge. Calls
/// visit(axis) until it returns true; returns whether it did. Zero vectors are skipped.
template <class Visit>
bool for_each_axis(const Skeleton& a, const Skeleton& b, const Visit& visit) {
  const auto try_axis = [&](const Axis& l) { return norm1(l) > 0 && visit(l); };
  if (a.has_normal && try_axis(a.normal)) return true;
  if (b.has_normal && try_axis(b.normal)) return true;
  for (int i = 0; i < a.edge_count; ++i) {
    for (int j = 0; j < b.edge_count; ++j) {
      if (try_axis(cross(a.edges[i], b.edges[j]))) return true;
    }
  }
  for (const Skeleton* s : {&a, &b}) {
    if (!s->has_normal) continue;
    for (int i = 0; i < s->edge_count; ++i) {
      if (try_axis(cross(s->normal, s->edges[i]))) return true;
    }
  }
  if (a.has_normal && b.has_normal) return false;
  const Axis offset = minus(a.middle, b.middle);
  if (try_axis(offset)) return true;
  for (const Skeleton* s : {&a, &b}) {
    for (int i = 0; i < s->edge_count; ++i) {
      if (try_axis(cross(s->edges[i], cross(offset, s->edges[i])))) return true;
    }
  }
  return false;
}

}  // namespace ccdfuzz::certified
