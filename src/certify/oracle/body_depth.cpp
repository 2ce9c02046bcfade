#include "certify/oracle/body_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "bezier/exact_patch.hpp"
#include "case/mesh.hpp"
#include "ccd/nearest_points.hpp"
#include "certify/oracle/rational_roots.hpp"
#include "certify/oracle/turned_points.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

/// Makes up for three products, quotients or roots of doubles and a sum, each rounded once.
constexpr double kRoundings = 1 - 0x1p-50;

/// v ≠ 0 times the power of two that brings its largest coordinate into [1/2, 1), exactly. So no
/// square of it leaves the range of doubles.
Vec3<Dyadic> of_size_one(const Vec3<Dyadic>& v) {
  std::optional<long> top;
  for (int k = 0; k < 3; ++k) {
    if (v[k].sign() == 0) continue;
    const long own = v[k].exponent() + static_cast<long>(bits_of(v[k].mantissa()));
    top = top ? std::max(*top, own) : own;
  }
  return {v[0].scaled(-*top), v[1].scaled(-*top), v[2].scaled(-*top)};
}

using Hull = Points<Dyadic>;

Points<Rational> rational(const Hull& hull) {
  Points<Rational> points;
  for (const Vec3<Dyadic>& p : hull) {
    points.push_back({p[0].rational(), p[1].rational(), p[2].rational()});
  }
  return points;
}

/// The directions between the points of a hull.
void add_directions(const Hull& hull, std::vector<Vec3<Dyadic>>& directions) {
  for (size_t i = 0; i < hull.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const Vec3<Dyadic> way = hull[i] - hull[j];
      if (way != Vec3<Dyadic>(0, 0, 0)) directions.push_back(way);
    }
  }
}

/// The lowest and the highest of a hull along a normal.
std::pair<Dyadic, Dyadic> range_along(const Vec3<Dyadic>& normal, const Hull& hull) {
  Dyadic low = dot(normal, hull[0]), high = low;
  for (const Vec3<Dyadic>& p : hull) {
    const Dyadic height = dot(normal, p);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return {low, high};
}

/// The least distance from the origin to the outside of the differences of points of the two
/// hulls, rounded down; 0 if these have no inside. That way is along the normal of a facet. Each
/// facet has two of the directions, one of each list, and all such pairs are tried.
double overlap_of(const Hull& swept, const Hull& rest, const std::vector<Vec3<Dyadic>>& directions,
                  const std::vector<Vec3<Dyadic>>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3<Dyadic>& one : directions) {
    for (const Vec3<Dyadic>& other : others) {
      if (&one == &other) break;  // of one list, each pair once
      const Vec3<Dyadic> product = cross(one, other);
      if (product == Vec3<Dyadic>(0, 0, 0)) continue;
      const Vec3<Dyadic> normal = of_size_one(product);
      const auto [low, high] = range_along(normal, swept);
      const auto [bottom, top] = range_along(normal, rest);
      const Dyadic overlap = std::min(high - bottom, top - low);
      const double length = std::sqrt(round_up(dot(normal, normal).rational()));
      least = std::min(least, kRoundings * round_down(overlap.rational()) / length);
      if (least == 0) return 0;  // as little as where they touch
    }
  }
  return std::isfinite(least) ? least : 0;
}

/// `more` and how deep two hulls overlap, or `more` less their distance. The first is swept in some
/// directions, from where it is `first`. Nothing where they overlap and have too many pairs of
/// points.
std::optional<double> depth_and(double more, const Hull& swept, const Hull& first, const Hull& rest,
                                std::vector<Vec3<Dyadic>> directions, bool in_plane) {
  NearestPoints nearest;
  const Rational squared = nearest(rational(swept), rational(rest)).squared;
  if (squared > 0) return more - round_up(root_above(squared));
  if (!is_measured(first.size(), rest.size())) return std::nullopt;
  add_directions(first, directions);
  add_directions(rest, directions);
  // In a plane, an edge and what is at right angles to the plane make a facet.
  const std::vector<Vec3<Dyadic>> upwards = {exact_dyadic({0, 0, 1})};
  return more + overlap_of(swept, rest, directions, in_plane ? upwards : directions);
}

/// A depth of overlap from below and from above. A distance is a depth below 0.
struct DepthBounds {
  double least, most;
};

/// The depth of overlap at one time.
std::optional<DepthBounds> depth_at(const Query& query, const Rational& t, bool in_plane) {
  std::array<PointsAt, 2> points;
  Rational largest = power_of_two(-1000);
  Rational reach = exact(query.separation), far = 0;
  for (size_t s = 0; s < 2; ++s) {
    const PointsAt& at = points[s] = points_at(query.patches[s], t);
    reach += exact(query.patches[s].radius);
    if (!at.are_exact) {
      far = std::max(far, exact(query.patches[s].turn->centre.cwiseAbs().maxCoeff()));
    }
    Fraction own = 0;
    for (const Vec3<Fraction>& p : at.dividends) {
      for (int k = 0; k < 3; ++k) own = std::max({own, p[k], -p[k]});
    }
    largest = std::max(largest, (own / at.divisor).rational());
  }
  // Each coordinate of both moves by less than the unit. points_at is off by 2^-96 of a distance
  // from a centre, at most 2 (largest + far). 2^-90 of far covers the centres' part of that.
  constexpr int kBits = 60, kTurnBits = 90;
  const Rational unit = power_below(largest) * power_of_two(-kBits);
  const double rounding = round_up(8 * unit + far * power_of_two(-kTurnBits));
  const long step = Dyadic::from(unit)->exponent();
  std::array<Hull, 2> hulls;
  for (size_t s = 0; s < 2; ++s) {
    for (const Vec3<Integer>& p : points[s].in_units(unit)) {
      hulls[s].push_back({Dyadic(p[0], step), Dyadic(p[1], step), Dyadic(p[2], step)});
    }
  }
  const double more = round_down(reach) - rounding;
  const auto measured = depth_and(more, hulls[0], hulls[0], hulls[1], {}, in_plane);
  if (!measured) return std::nullopt;
  const double depth = std::max(*measured, -std::numeric_limits<double>::max());
  // Points are off by `rounding` to either side. What the arithmetic of doubles adds is far less
  // than this share of its operands.
  constexpr double kOff = 0x1p-40;
  const double off = kOff * std::abs(depth) + kOff * std::abs(more);
  return DepthBounds{depth - off,
                     std::min(depth + off + 2 * rounding, std::numeric_limits<double>::max())};
}

/// At most so many radians a body turns in a unit of time by a `turn`.
Rational greatest_turn(const BodyTurn& turn) {
  const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
    Rational sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += exact(a[i]) * exact(b[i]);
    return sum;
  };
  // In its plane q turns by |from × to| / |q|² in a unit of time, half as much as the body if it is
  // a quaternion. |q|² is a mean of the three products (Bernstein).
  const Rational first = product(turn.from, turn.from), mixed = product(turn.from, turn.to),
                 last = product(turn.to, turn.to);
  return (turn.is_quaternion() ? 2 : 1) * root_above(first * last - mixed * mixed) /
         std::min({first, mixed, last});
}

/// The deepest overlap at any time of [0, until], where a body turns. No point of one moves faster
/// against the other than greatest_speed, and the depth does not change faster.
class DeepestOverlap {
 public:
  DeepestOverlap(const Query& query, double until, bool in_plane)
      : query_(query), in_plane_(in_plane), speed_(greatest_speed(query)) {
    pieces_.push_back({std::numeric_limits<double>::infinity(), 0, exact(until)});
  }

  /// It is this deep, and no deeper; 0 where they do not overlap.
  double least() const { return least_; }
  double most() const { return std::max(0.0, pieces_.front().most); }

  /// Looks at the end, and refines until that is done, or for some seconds. False: the depth is not
  /// measured.
  template <class Done>
  bool refine_until(const Done& is_done) {
    // To measure an overlap takes time as the square of the directions between points of a hull.
    constexpr size_t kMostRefined = 128, kMostSquares = 1 << 18;
    size_t directions = 1;
    for (const MovingPatch<double>& body : query_.patches) {
      directions += body.positions.size() * (body.positions.size() - 1) / 2;
    }
    size_t left = std::clamp<size_t>(kMostSquares / (directions * directions), 1, kMostRefined);
    const auto last = depth_at(query_, pieces_.front().until, in_plane_);  // where hits are late
    if (!last) return false;
    least_ = std::max(least_, last->least);
    for (; left > 0 && !is_done(); --left) {
      if (!refine()) return false;
    }
    return true;
  }

 private:
  struct Piece {
    double most;  ///< no deeper than this in it
    Rational from, until;
  };

  /// Halves the piece of time in which it may be deepest, and looks at the middle of each half.
  /// False: the depth is not measured there.
  bool refine() {
    std::ranges::pop_heap(pieces_, {}, &Piece::most);
    const auto [most, from, until] = pieces_.back();
    pieces_.pop_back();
    const Rational half = (until - from) / 2;
    for (const Rational& begin : {from, Rational(from + half)}) {
      const Rational end = begin + half;
      const auto depth = depth_at(query_, (begin + end) / 2, in_plane_);
      if (!depth) return false;
      least_ = std::max(least_, depth->least);
      const Rational bound = exact(depth->most) + speed_ * half / 2;
      pieces_.push_back({std::min(most, round_up(bound)), begin, end});
      std::ranges::push_heap(pieces_, {}, &Piece::most);
    }
    return true;
  }

  const Query& query_;
  bool in_plane_;
  Rational speed_;
  double least_ = 0;
  std::vector<Piece> pieces_;  ///< a heap
};

}  // namespace

Rational greatest_speed(const Query& query) {
  const auto length = [](const Vec3<Rational>& v) { return root_above(dot(v, v)); };
  const auto& [a, b] = query.patches;
  Rational speed = length(exact(a.velocities[0]) - exact(b.velocities[0]));
  for (const MovingPatch<double>& body : query.patches) {
    if (!body.turn) continue;
    const BodyTurn& turn = *body.turn;
    const bool spins = turn.is_spin();
    Rational reach = 0;
    for (const Vec3<double>& p : body.positions) {
      const Vec3<Rational> arm = exact(p) - exact(turn.centre);
      // A point that spins keeps its distance from the axis, and so its speed.
      const Vec3<Rational> moves =
          spins ? cross(exact(Vec3<double>(turn.spin[0], turn.spin[1], turn.spin[2])), arm) : arm;
      reach = std::max(reach, length(moves));
    }
    speed += spins ? reach : reach * greatest_turn(turn);
  }
  return speed;
}

std::optional<double> depth_until(const Query& query, double until, bool in_plane) {
  if (has_turns(query)) {
    constexpr double kNear = 1.25;  // right to a quarter
    DeepestOverlap overlap(query, until, in_plane);
    const auto is_near = [&] { return overlap.most() <= kNear * overlap.least(); };
    return overlap.refine_until(is_near) ? std::optional(overlap.least()) : std::nullopt;
  }
  if (has_mesh(query)) {
    double deepest = 0;
    for (const size_t face : faces_there(query)) {
      const auto depth = depth_until(of_face(query, face), until, in_plane);
      if (!depth) return std::nullopt;
      deepest = std::max(deepest, *depth);
    }
    return deepest;
  }
  const auto a = exact_patch<Dyadic>(query.patches[0]), b = exact_patch<Dyadic>(query.patches[1]);
  const Vec3<Dyadic> way = (a.velocities[0] - b.velocities[0]) * Dyadic::exact(until);
  Hull swept = a.positions;
  for (const Vec3<Dyadic>& p : a.positions) swept.push_back(p + way);
  const Dyadic reach = Dyadic::exact(query.separation) + a.radius + b.radius;
  const auto depth =
      depth_and(round_down(reach.rational()), swept, a.positions, b.positions, {way}, in_plane);
  return depth ? std::optional(std::max(0.0, kRoundings * *depth)) : depth;
}

std::optional<bool> is_deeper_until(const Query& query, double until, const Rational& most,
                                    bool in_plane) {
  const double limit = round_down(most);
  if (!has_turns(query)) {
    const std::optional<double> depth = depth_until(query, until, in_plane);
    return depth ? std::optional(*depth > limit) : std::nullopt;
  }
  DeepestOverlap overlap(query, until, in_plane);
  overlap.refine_until([&] { return overlap.least() > limit || overlap.most() <= limit; });
  // What passes through thin bodies overlaps less at any time than it would have to be moved.
  return overlap.least() > limit ? std::optional(true) : std::nullopt;
}

}  // namespace ccdfuzz
