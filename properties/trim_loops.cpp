#include <algorithm>
#include <optional>

#include "bezier/trim.hpp"
#include "numeric/rational.hpp"
#include "properties/draw_trimmed.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

using Loop = std::vector<Uv<double>>;
using Place = Uv<Rational>;
using Places = std::vector<Place>;

const Shape kSquare = Shape::tensor(1, 1);

/// Corners of squares of 1/4: many are on edges and lines of others.
Loop draw_loop(Draw& d, std::size_t vertices) {
  Loop loop(vertices);
  for (Uv<double>& p : loop) {
    for (double& x : p) x = static_cast<double>(d.below(5)) / 4;
  }
  return loop;
}

Places exact_loop(const Loop& loop) {
  Places places;
  for (const Uv<double>& p : loop) places.push_back(exact_place(p));
  return places;
}

Place way(const Place& from, const Place& to) {
  return {to[0] - from[0], to[1] - from[1]};
}

Rational cross(const Place& a, const Place& b) {
  return a[0] * b[1] - a[1] * b[0];
}

Rational dot(const Place& a, const Place& b) {
  return a[0] * b[0] + a[1] * b[1];
}

/// Where the lines of the segments ab and cd, none of length 0, meet: the shares of ab and of cd
/// that are before it. Nothing if they are parallel.
std::optional<Place> meeting_of_lines(const Place& a, const Place& b, const Place& c,
                                      const Place& d) {
  const Place along = way(a, b), other = way(c, d), offset = way(a, c);
  const Rational turn = cross(along, other);
  if (turn == 0) return std::nullopt;
  return Place{cross(offset, other) / turn, cross(offset, along) / turn};
}

bool share_point(const Place& a, const Place& b, const Place& c, const Place& d) {
  if (const auto at = meeting_of_lines(a, b, c, d)) {
    return std::ranges::all_of(*at, [](const Rational& x) { return 0 <= x && x <= 1; });
  }
  const Place along = way(a, b), offset = way(a, c);
  if (cross(offset, along) != 0) return false;
  const Rational of_c = dot(offset, along), of_d = dot(way(a, d), along);
  return std::max(of_c, of_d) >= 0 && std::min(of_c, of_d) <= dot(along, along);
}

/// Whether they have one point in common, which is no end of either.
bool cross_inside(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto at = meeting_of_lines(a, b, c, d);
  return at && std::ranges::all_of(*at, [](const Rational& x) { return 0 < x && x < 1; });
}

/// Whether edges from b to a and to c have more in common than b.
bool fold(const Place& a, const Place& b, const Place& c) {
  return cross(way(b, a), way(b, c)) == 0 && dot(way(b, a), way(b, c)) > 0;
}

/// Whether two edges have more in common than the vertex between them, or one has no length.
bool is_spoilt(const Places& loop) {
  const std::size_t n = loop.size();
  const auto at = [&](std::size_t i) -> const Place& { return loop[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (at(i) == at(i + 1)) return true;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (fold(at(i), at(i + 1), at(i + 2))) return true;
    for (std::size_t j = i + 2; j < n && j + 1 < n + i; ++j) {
      if (share_point(at(i), at(i + 1), at(j), at(j + 1))) return true;
    }
  }
  return false;
}

/// 1 inside of a triangle, 0 on its edges, −1 outside.
int place_in(const Places& triangle, const Place& at) {
  const auto area = [](const Place& a, const Place& b, const Place& c) {
    return cross(way(a, b), way(a, c));
  };
  const int turn = sgn(area(triangle[0], triangle[1], triangle[2]));
  int least = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min(least, turn * sgn(area(triangle[i], triangle[(i + 1) % 3], at)));
  }
  return least;
}

/// Whether vertices of q are inside and outside of p.
bool has_both_sides(const Places& p, const Places& q) {
  const auto has = [&](int place) {
    return std::ranges::any_of(q, [&](const Place& at) { return place_in(p, at) == place; });
  };
  return has(1) && has(-1);
}

/// One loop, or two triangles.
void check_loops(Draw& d) {
  const bool are_two = d.coin();
  const Loop p = show(d, "loop", draw_loop(d, are_two ? 3 : 3 + d.below(4)));
  const Places a = exact_loop(p);
  CLAIM(fault_of({p}, kSquare).has_value() == is_spoilt(a));
  if (!are_two) return;
  const Loop q = show(d, "other", draw_loop(d, 3));
  const Places b = exact_loop(q);
  bool is_refused = is_spoilt(a) || is_spoilt(b) || has_both_sides(a, b) || has_both_sides(b, a);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      is_refused |= cross_inside(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
    }
  }
  CLAIM(fault_of({p, q}, kSquare).has_value() == is_refused);
}

}  // namespace

std::vector<Property> trim_loops_claims() {
  return {{"trims.loops",
           "A loop is refused iff two of its edges share more than the vertex between them; two "
           "triangles are, too, iff edges cross, or one has vertices in and out of the other",
           "src/bezier/trim.hpp", check_loops}};
}

}  // namespace ccdfuzz
