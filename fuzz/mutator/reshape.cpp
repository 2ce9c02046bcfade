#include "bezier/cell.hpp"
#include "bezier/elevate.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "fuzz/mutator/moves.hpp"
#include "fuzz/mutator/repair.hpp"
#include "generators/weighted.hpp"
#include "numeric/small_dyadic.hpp"

namespace ccdfuzz {

namespace {

/// v / by, if that is dyadic; lost where v is. Dyadic numbers have that of generators/weighted.hpp.
std::optional<Vec3<SmallDyadic>> divided(const Vec3<SmallDyadic>& v, const SmallDyadic& by) {
  Vec3<SmallDyadic> out;
  for (int k = 0; k < 3; ++k) {
    const auto quotient = v[k].divided(by);
    if (!quotient) return std::nullopt;
    out[k] = *quotient;
  }
  return out;
}

/// The points of a patch with a degree one higher, where they are dyadic.
template <class S>
std::optional<Points<S>> points_of_higher(const Shape& shape, const Points<S>& points, bool in_v) {
  Elevated<S> higher = elevated(shape, points, in_v);
  for (Vec3<S>& p : higher.points) {
    const auto mean = divided(p, S(higher.times));
    if (!mean) return std::nullopt;
    p = *mean;
  }
  return std::move(higher.points);
}

template <class S>
std::optional<Points<S>> restricted(const Shape& shape, const Points<S>& points, const Cell& cell) {
  Points<S> part(points.size());
  restrict_to<S>(shape, points, exact_corners<S>(cell.corners(shape)), part);
  return part;
}

bool all_fit(const Points<SmallDyadic>& points) {
  return std::ranges::all_of(
      points, [](const Vec3<SmallDyadic>& p) { return p[0].fits() && p[1].fits() && p[2].fits(); });
}

/// Other points in the place of some, if all of them are doubles. make<S>(points): nullopt if they
/// are not dyadic.
template <class Make>
bool replace_points(Points<double>& points, const Make& make) {
  std::optional<Points<double>> made;
  const auto small = make(exact_points<SmallDyadic>(points));
  if (!small) return false;
  if (all_fit(*small)) {
    made = to_doubles(*small);
  } else if (const auto exact = make(exact_points<Dyadic>(points))) {
    made = to_doubles(*exact);
  }
  if (!made) return false;
  points = *std::move(made);
  return true;
}

/// Patch `side` by parameters in another order; the place of the contact with it. way: any number.
void reparametrise_patch(Contact& q, size_t side, std::uint64_t way) {
  MovingPatch<double>& patch = q.query.patches[side];
  Uv<Dyadic>& uv = q.uv[side];
  const Shape shape = patch.shape;
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return;
    case ShapeKind::kCurve:
      patch = picked(patch, shape, [&](int i, int) { return shape.n - i; });
      uv[0] = Dyadic(1) - uv[0];
      return;
    case ShapeKind::kTriangle: {
      constexpr std::array<std::array<size_t, 3>, 5> kOrders = {
          {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
      const std::array<size_t, 3>& order = kOrders[way % kOrders.size()];
      const std::array<Dyadic, 3> x = {uv[0], uv[1], Dyadic(1) - uv[0] - uv[1]};
      // Barycentric a of the result is barycentric order[a] of the patch.
      patch = picked(patch, shape, [&](int i, int j) {
        const std::array<int, 3> power = {i, j, shape.n - i - j};
        std::array<int, 3> old{};
        for (size_t a = 0; a < 3; ++a) old[order[a]] = power[a];
        return shape.index(old[0], old[1]);
      });
      uv = {x[order[0]], x[order[1]]};
      return;
    }
    case ShapeKind::kTensor: {
      const bool transpose = way % 2 == 0;
      const Shape turned = transpose ? Shape::tensor(shape.m, shape.n) : shape;
      patch = picked(patch, turned, [&](int i, int j) {
        return transpose ? shape.index(j, i) : shape.index(shape.n - i, j);
      });
      if (transpose) {
        std::swap(uv[0], uv[1]);
      } else {
        uv[0] = Dyadic(1) - uv[0];
      }
      return;
    }
  }
}

}  // namespace

bool reparametrise(Contact& q, Draw& draw) {
  if (draw.below(4) == 0) {
    std::swap(q.query.patches[0], q.query.patches[1]);
    std::swap(q.uv[0], q.uv[1]);
    return true;
  }
  const size_t side = draw.below(2);
  if (!q.query.patches[side].trim.empty()) return false;
  reparametrise_patch(q, side, draw.choose(~std::uint64_t{0}));
  return true;
}

bool elevate_degree(Contact& q, Draw& draw) {
  MovingPatch<double>& patch = q.query.patches[draw.below(2)];
  const bool in_v = draw.coin();
  const Shape higher = elevated(patch.shape, in_v);
  if (!higher.valid() || !patch.weights.empty()) return false;  // quotients would be rounded
  const auto make = [&](const auto& points) { return points_of_higher(patch.shape, points, in_v); };
  if (!replace_points(patch.positions, make) || !replace_points(patch.moves(), make)) {
    return false;
  }
  patch.shape = higher;
  return true;
}

bool restrict_to_child(Contact& q, Draw& draw) {
  const size_t side = draw.below(2);
  MovingPatch<double>& patch = q.query.patches[side];
  const Shape shape = patch.shape;
  if (!patch.weights.empty() || !patch.trim.empty()) return false;  // numbers would be rounded
  const Uv<Rational> at = {q.uv[side][0].rational(), q.uv[side][1].rational()};
  for (int c = 0; c < shape.child_count() && shape.kind != ShapeKind::kPoint; ++c) {
    const Cell cell = Cell{}.child(shape, c);
    if (!contains(cell, shape, at)) continue;
    const auto make = [&](const auto& points) { return restricted(shape, points, cell); };
    if (!replace_points(patch.positions, make) || !replace_points(patch.moves(), make)) {
      return false;
    }
    for (size_t k = 0; k < static_cast<size_t>(shape.parameter_count()); ++k) {
      const Dyadic local =
          q.uv[side][k].scaled(1) - Dyadic(static_cast<int>(k == 0 ? cell.i : cell.j));
      q.uv[side][k] = cell.inverted ? Dyadic(1) - local : local;
    }
    return true;
  }
  return false;
}

}  // namespace ccdfuzz
