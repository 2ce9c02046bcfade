#pragma once

#include "case/query.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// Points, curves and triangles of degree 1 at most: the image of a polygon is one.
bool are_flat(const Query& query);

/// So many exact distances of edges take about a tenth of a second.
inline constexpr int kMostEdgePairs = 4096;

/// The squared distance of the regions of two flat patches at the start, exactly. If it is no more
/// than `enough`, some number that is ≤ enough. So it is, too, where kMostEdgePairs pairs of edges,
/// which boxes do not tell apart, decide nothing.
///
/// Proof. Nearest points inside of both regions can move alike, along both planes, until one is on
/// an edge. So the distance is that of an edge and the other region. Let a' be the nearest point to
/// the edge that the whole patch has. If it is in the region, that is the distance. Else let a,
/// inside of the region, be nearest to the edge. No point of the whole patch is nearer, as the
/// distance of convex sets has no other local minimum. So all from a to a' are as near, with points
/// of that edge, and one of them is on an edge of the region. A triangle without extent is the
/// image of its edges.
Rational squared_distance_of_regions(const Query& query, const Rational& enough);

}  // namespace ccdfuzz
