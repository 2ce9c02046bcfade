#include "certify/checker/check_trim.hpp"

#include <algorithm>

namespace ccdfuzz {

namespace {

using Point = Uv<Rational>;

std::uint64_t words_of_point(const Point& p) {
  return words_of(p[0]) + words_of(p[1]);
}

/// On which side of the line from a to b the point lies: the sign of (b − a) × (p − a).
int side_of(const Point& a, const Point& b, const Point& p, Work& work) {
  work.charge(4 * fraction_work(words_of_point(a) + words_of_point(b) + words_of_point(p)));
  return sgn(Rational((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])));
}

/// The only side on which all points lie strictly, or 0.
int common_side(const Point& a, const Point& b, std::span<const Point> points, Work& work) {
  const int side = side_of(a, b, points[0], work);
  for (const Point& p : points.subspan(1)) {
    if (side_of(a, b, p, work) != side) return 0;
  }
  return side;
}

/// All of one is left of, right of, below or above the other.
bool are_apart_on_axes(std::span<const Point> a, std::span<const Point> b) {
  for (const size_t k : {size_t{0}, size_t{1}}) {
    const auto less = [k](const Point& p, const Point& q) { return p[k] < q[k]; };
    const auto [least_a, most_a] = std::ranges::minmax_element(a, less);
    const auto [least_b, most_b] = std::ranges::minmax_element(b, less);
    if ((*most_a)[k] < (*least_b)[k] || (*most_b)[k] < (*least_a)[k]) return true;
  }
  return false;
}

/// Two disjoint convex polygons have the line of a side of one between them. A segment has two
/// sides, both on its line; sides without length tell nothing, and two points are told by axes.
bool meet(std::span<const Point> polygon, const std::array<Point, 2>& segment, Work& work) {
  constexpr std::uint64_t kComparisons = 64;  // with numbers of a double, of up to 18 words
  for (const Point& p : polygon) work.charge(kComparisons * words_of_point(p));
  if (are_apart_on_axes(polygon, segment)) return false;
  if (common_side(segment[0], segment[1], polygon, work) != 0) return false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const int beyond = common_side(a, b, segment, work);
    if (beyond == 0) continue;
    const bool all_on_this_side = std::ranges::all_of(
        polygon, [&](const Point& p) { return side_of(a, b, p, work) != beyond; });
    if (all_on_this_side) return false;
  }
  return true;
}

/// Calls visit(edge) on the edges of all loops, until it returns true. Returns whether it did.
template <class Visit>
bool any_edge(const Trim& trim, const Visit& visit) {
  for (const auto& loop : trim) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const auto &from = loop[i], &to = loop[(i + 1) % loop.size()];
      const std::array<Point, 2> edge = {Point{exact(from[0]), exact(from[1])},
                                         Point{exact(to[0]), exact(to[1])}};
      if (visit(edge)) return true;
    }
  }
  return false;
}

/// Whether the ray from p towards larger u crosses an odd number of edges, of which the lower ends
/// belong to them. p lies on no edge.
bool has_odd_crossings(const Trim& trim, const Point& p, Work& work) {
  bool odd = false;
  any_edge(trim, [&](const std::array<Point, 2>& edge) {
    const bool rises = edge[0][1] <= p[1] && p[1] < edge[1][1];
    const bool falls = edge[1][1] <= p[1] && p[1] < edge[0][1];
    if (rises || falls) odd ^= side_of(edge[0], edge[1], p, work) == (rises ? 1 : -1);
    return false;
  });
  return odd;
}

}  // namespace

Region region_of(const Trim& trim, std::span<const Point> vertices, Work& work) {
  if (trim.empty()) return Region::kInside;
  if (any_edge(trim, [&](const auto& edge) { return meet(vertices, edge, work); })) {
    return Region::kTouching;
  }
  return has_odd_crossings(trim, vertices[0], work) ? Region::kInside : Region::kOutside;
}

bool is_on_one_edge(const Trim& trim, std::span<const Point> points, Work& work) {
  return any_edge(trim, [&](const std::array<Point, 2>& edge) {
    return std::ranges::all_of(points,
                               [&](const Point& p) { return meet(std::span(&p, 1), edge, work); });
  });
}

bool is_in_region(const Trim& trim, const Point& at, Work& work) {
  return region_of(trim, std::span(&at, 1), work) != Region::kOutside;
}

}  // namespace ccdfuzz
