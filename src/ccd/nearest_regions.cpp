#include "ccd/nearest_regions.hpp"

#include <algorithm>
#include <optional>

#include "bezier/bernstein.hpp"
#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "ccd/nearest_points.hpp"

namespace ccdfuzz {

namespace {

/// The ends of the edges of a flat patch at the start. A point is an edge of its own.
std::vector<Points<Rational>> edges_of(const MovingPatch<double>& patch) {
  const MovingPatch<Rational> exactly = exact_patch<Rational>(patch);
  std::vector<Points<Rational>> edges;
  const auto add_loop = [&](const Points<Rational>& loop) {
    for (size_t i = 0; i < loop.size(); ++i)
      edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
  };
  if (patch.trim.empty()) add_loop(exactly.positions);
  for (const auto& loop : patch.trim) {
    Points<Rational> image;
    for (const Uv<double>& uv : loop) {
      image.push_back(evaluate<Rational>(patch.shape, exactly.positions, exactly.weights,
                                         {exact(uv[0]), exact(uv[1])}));
    }
    add_loop(image);
  }
  return edges;
}

/// Whether the trim's region has the point that the patch without weights has at uv. On an edge of
/// a loop it may be either.
bool covers(const MovingPatch<double>& patch, const std::vector<Rational>& weights,
            const Uv<Rational>& uv) {
  if (patch.trim.empty()) return true;
  const Uv<Rational> at = parameters_with_weights(patch.shape, weights, uv);
  bool odd = false;
  for (const auto& loop : patch.trim) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const auto &from = loop[i], &to = loop[(i + 1) % loop.size()];
      const Rational v = exact(from[1]) - at[1], next_v = exact(to[1]) - at[1];
      if ((v <= 0) == (next_v <= 0)) continue;
      const Rational u = exact(from[0]) - at[0], next_u = exact(to[0]) - at[0];
      odd ^= (u * next_v > v * next_u) == (next_v > v);
    }
  }
  return odd;
}

/// Whether their boxes show that edges are no nearer than this squared distance.
bool are_apart(const Points<Rational>& edge, const Points<Rational>& other,
               const Rational& squared) {
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax(edge[0][k], edge[1][k]);
    const auto [other_low, other_high] = std::minmax(other[0][k], other[1][k]);
    Rational gap = 0;
    if (low > other_high) gap = low - other_high;
    if (other_low > high) gap = other_low - high;
    if (gap > 0 && gap * gap >= squared) return true;
  }
  return false;
}

}  // namespace

bool are_flat(const Query& query) {
  return std::ranges::all_of(query.patches, [](const MovingPatch<double>& patch) {
    return patch.shape.kind < ShapeKind::kTensor && patch.shape.n <= 1;
  });
}

Rational squared_distance_of_regions(const Query& query, const Rational& enough) {
  const std::array<std::vector<Points<Rational>>, 2> edges = {edges_of(query.patches[0]),
                                                              edges_of(query.patches[1])};
  std::optional<Rational> least;
  int pairs = 0;
  const auto is_enough = [&](const Rational& squared) {
    if (!least || squared < *least) least = squared;
    return *least <= enough;
  };
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Rational> whole = exact_patch<Rational>(query.patches[s]);
    for (const Points<Rational>& edge : edges[1 - s]) {
      NearestPoints nearest;
      const NearestPoints::Found& found = nearest(whole.positions, edge);
      if (least && found.squared >= *least) continue;
      // A triangle's corners are at (0, 0), (0, 1) and (1, 0).
      const std::vector<Rational>& shares = found.weights[0];
      const Uv<Rational> uv = {shares.back(), shares[shares.size() / 2]};
      if (covers(query.patches[s], whole.weights, uv)) {
        if (is_enough(found.squared)) return *least;
        continue;
      }
      for (const Points<Rational>& other : edges[s]) {
        if (least && are_apart(edge, other, *least)) continue;
        if (++pairs > kMostEdgePairs) return enough;
        if (is_enough(NearestPoints()(other, edge).squared)) return *least;
      }
    }
  }
  return *least;
}

}  // namespace ccdfuzz
