#include "fuzz/mutator/reshape.hpp"

#include "bezier/cell.hpp"
#include "bezier/restrict.hpp"
#include "bezier/to_doubles.hpp"

namespace ccdfuzz {

namespace {

/// Control point i of the result is control point from[i].
void permute(MovingPatch<double>& patch, const Shape& shape, const std::vector<int>& from) {
  const MovingPatch<double> old = patch;
  patch.shape = shape;
  for (size_t i = 0; i < from.size(); ++i) {
    patch.positions[i] = old.positions[static_cast<size_t>(from[i])];
    patch.velocities[i] = old.velocities[static_cast<size_t>(from[i])];
  }
}

/// The places of control points when barycentric a of the result is barycentric order[a] of the
/// patch; barycentrics in the order u, v, w.
std::vector<int> permuted_triangle(const Shape& shape, const std::array<size_t, 3>& order) {
  std::vector<int> from;
  for (int i = 0; i <= shape.n; ++i) {
    for (int j = 0; j <= shape.n - i; ++j) {
      const std::array<int, 3> power = {i, j, shape.n - i - j};
      std::array<int, 3> old{};
      for (size_t a = 0; a < 3; ++a) old[order[a]] = power[a];
      from.push_back(shape.index(old[0], old[1]));
    }
  }
  return from;
}

/// v / by, if that is dyadic.
std::optional<Vec3<Dyadic>> divided(const Vec3<Dyadic>& v, int by) {
  Vec3<Dyadic> out;
  for (int k = 0; k < 3; ++k) {
    Integer rest = v[k].mantissa();
    long exponent = v[k].exponent();
    int odd = by;
    for (; odd % 2 == 0; odd /= 2) --exponent;
    if (rest % odd != 0) return std::nullopt;
    rest /= odd;
    out[k] = Dyadic(std::move(rest), exponent);
  }
  return out;
}

/// Degree elevation of a row of control points: each is a mean of two of its neighbours.
std::optional<Points<Dyadic>> elevated_row(const Points<Dyadic>& row) {
  const int n = static_cast<int>(row.size());  // the new degree
  Points<Dyadic> out;
  for (int i = 0; i <= n; ++i) {
    Vec3<Dyadic> sum = {Dyadic(), Dyadic(), Dyadic()};
    if (i > 0) sum += row[static_cast<size_t>(i - 1)] * Dyadic(i);
    if (i < n) sum += row[static_cast<size_t>(i)] * Dyadic(n - i);
    const auto mean = divided(sum, n);
    if (!mean) return std::nullopt;
    out.push_back(*mean);
  }
  return out;
}

std::optional<Points<Dyadic>> elevated_triangle(const Shape& shape, const Points<Dyadic>& points) {
  const int n = shape.n + 1;
  Points<Dyadic> out;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n - i; ++j) {
      const int k = n - i - j;
      Vec3<Dyadic> sum = {Dyadic(), Dyadic(), Dyadic()};
      const auto add = [&](int times, int a, int b) {
        if (times > 0) sum += points[static_cast<size_t>(shape.index(a, b))] * Dyadic(times);
      };
      add(i, i - 1, j);
      add(j, i, j - 1);
      add(k, i, j);
      const auto mean = divided(sum, n);
      if (!mean) return std::nullopt;
      out.push_back(*mean);
    }
  }
  return out;
}

std::optional<Points<Dyadic>> elevated_tensor(const Shape& shape, const Points<Dyadic>& points,
                                              bool in_v) {
  const int rows = in_v ? shape.n : shape.m;  // how many lines less one are elevated
  const Shape higher =
      in_v ? Shape::tensor(shape.n, shape.m + 1) : Shape::tensor(shape.n + 1, shape.m);
  Points<Dyadic> out(static_cast<size_t>(higher.control_count()));
  for (int r = 0; r <= rows; ++r) {
    const auto place = [&](const Shape& s, int i) { return in_v ? s.index(r, i) : s.index(i, r); };
    Points<Dyadic> row;
    for (int i = 0; i <= (in_v ? shape.m : shape.n); ++i) {
      row.push_back(points[static_cast<size_t>(place(shape, i))]);
    }
    const auto elevated = elevated_row(row);
    if (!elevated) return std::nullopt;
    for (size_t i = 0; i < elevated->size(); ++i) {
      out[static_cast<size_t>(place(higher, static_cast<int>(i)))] = (*elevated)[i];
    }
  }
  return out;
}

/// Replaces a patch by one with other points, if all of them are doubles.
template <class Make>
bool replace_points(MovingPatch<double>& patch, const Shape& shape, const Make& make) {
  const MovingPatch<Dyadic> exact = exact_patch<Dyadic>(patch);
  const auto as_doubles = [&](const Points<Dyadic>& from) -> std::optional<Points<double>> {
    const std::optional<Points<Dyadic>> made = make(from);
    return made ? to_doubles(*made) : std::nullopt;
  };
  const auto positions = as_doubles(exact.positions), velocities = as_doubles(exact.velocities);
  if (!positions || !velocities) return false;
  patch = {shape, *positions, *velocities};
  return true;
}

}  // namespace

void reparametrise_patch(WitnessedQuery& q, int side, std::uint64_t way) {
  const size_t s = static_cast<size_t>(side);
  MovingPatch<double>& patch = q.query.patches[s];
  Uv<Dyadic>& uv = q.uv[s];
  const Shape shape = patch.shape;
  std::vector<int> from;
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return;
    case ShapeKind::kCurve:
      for (int i = shape.n; i >= 0; --i) from.push_back(i);
      permute(patch, shape, from);
      uv[0] = Dyadic(1) - uv[0];
      return;
    case ShapeKind::kTriangle: {
      constexpr std::array<std::array<size_t, 3>, 5> kOrders = {
          {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
      const std::array<size_t, 3>& order = kOrders[way % kOrders.size()];
      const std::array<Dyadic, 3> x = {uv[0], uv[1], Dyadic(1) - uv[0] - uv[1]};
      permute(patch, shape, permuted_triangle(shape, order));
      uv = {x[order[0]], x[order[1]]};
      return;
    }
    case ShapeKind::kTensor: {
      const bool transpose = way % 2 == 0;
      const Shape turned = transpose ? Shape::tensor(shape.m, shape.n) : shape;
      for (int i = 0; i <= turned.n; ++i) {
        for (int j = 0; j <= turned.m; ++j) {
          from.push_back(transpose ? shape.index(j, i) : shape.index(shape.n - i, j));
        }
      }
      permute(patch, turned, from);
      if (transpose) {
        std::swap(uv[0], uv[1]);
      } else {
        uv[0] = Dyadic(1) - uv[0];
      }
      return;
    }
  }
}

bool elevate_patch(WitnessedQuery& q, int side, bool in_v) {
  MovingPatch<double>& patch = q.query.patches[static_cast<size_t>(side)];
  Shape higher = patch.shape;
  in_v = in_v && higher.kind == ShapeKind::kTensor;
  (in_v ? higher.m : higher.n) += 1;
  if (!higher.valid()) return false;
  return replace_points(patch, higher,
                        [&](const Points<Dyadic>& points) -> std::optional<Points<Dyadic>> {
                          switch (higher.kind) {
                            case ShapeKind::kPoint:
                              return std::nullopt;
                            case ShapeKind::kCurve:
                              return elevated_row(points);
                            case ShapeKind::kTriangle:
                              return elevated_triangle(patch.shape, points);
                            case ShapeKind::kTensor:
                              return elevated_tensor(patch.shape, points, in_v);
                          }
                          return std::nullopt;
                        });
}

bool restrict_patch(WitnessedQuery& q, int side) {
  const size_t s = static_cast<size_t>(side);
  MovingPatch<double>& patch = q.query.patches[s];
  const Shape shape = patch.shape;
  const Uv<Rational> at = {q.uv[s][0].rational(), q.uv[s][1].rational()};
  for (int c = 0; c < shape.child_count() && shape.kind != ShapeKind::kPoint; ++c) {
    const Cell cell = Cell{}.child(shape, c);
    if (!cell.contains(shape, at)) continue;
    const auto corners = exact_corners<Dyadic>(cell.corners(shape));
    const auto restricted = [&](const Points<Dyadic>& points) {
      Points<Dyadic> part(points.size());
      restrict_to<Dyadic>(shape, points, corners, part);
      return std::optional(part);
    };
    if (!replace_points(patch, shape, restricted)) return false;
    for (size_t k = 0; k < static_cast<size_t>(shape.parameter_count()); ++k) {
      const Dyadic local =
          q.uv[s][k].scaled(1) - Dyadic(static_cast<int>(k == 0 ? cell.i : cell.j));
      q.uv[s][k] = cell.inverted ? Dyadic(1) - local : local;
    }
    return true;
  }
  return false;
}

}  // namespace ccdfuzz
