#include "properties/symmetry.hpp"

#include <algorithm>

#include "bezier/elevate.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

namespace {

/// Exact points as doubles, if they are.
std::optional<Points<double>> as_doubles(const Points<Dyadic>& points) {
  Points<double> out;
  for (const Vec3<Dyadic>& p : points) {
    Vec3<double> rounded;
    for (int k = 0; k < 3; ++k) {
      const auto x = p[k].to_double_exactly();
      if (!x) return std::nullopt;
      rounded[k] = *x;
    }
    out.push_back(rounded);
  }
  return out;
}

std::optional<MovingPatch<double>> as_doubles(const MovingPatch<Dyadic>& patch) {
  const auto positions = as_doubles(patch.positions), velocities = as_doubles(patch.velocities);
  if (!positions || !velocities) return std::nullopt;
  return MovingPatch<double>{patch.shape, *positions, *velocities};
}

/// The same patch with its parameters in another order: control point (i, j) of the result is that
/// of the old indices, and so are the parameters.
void reverse_parameters(MovingPatch<double>& patch, Uv<Rational>& uv, std::uint64_t way) {
  const Shape old = patch.shape;
  const auto rearrange = [&](const Shape& shape, const auto& source) {
    MovingPatch<double> out{shape, patch.positions, patch.velocities};
    const int rows = shape.kind == ShapeKind::kPoint ? 0 : shape.n;
    for (int i = 0; i <= rows; ++i) {
      const int columns = shape.kind == ShapeKind::kTriangle ? shape.n - i
                          : shape.kind == ShapeKind::kTensor ? shape.m
                                                             : 0;
      for (int j = 0; j <= columns; ++j) {
        const auto to = static_cast<std::size_t>(shape.index(i, j));
        const auto [from_i, from_j] = source(i, j);
        const auto from = static_cast<std::size_t>(old.index(from_i, from_j));
        out.positions[to] = patch.positions[from];
        out.velocities[to] = patch.velocities[from];
      }
    }
    patch = out;
  };
  using Indices = std::array<int, 2>;
  switch (old.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return;
    case ShapeKind::kCurve:
      rearrange(old, [&](int i, int) { return Indices{old.n - i, 0}; });
      uv[0] = 1 - uv[0];
      return;
    case ShapeKind::kTriangle:
      if (way == 0) {  // u ↔ v
        rearrange(old, [&](int i, int j) { return Indices{j, i}; });
        std::swap(uv[0], uv[1]);
      } else {  // the new u is the old w, the new v the old u
        rearrange(old, [&](int i, int j) { return Indices{j, old.n - i - j}; });
        uv = {Rational(1 - uv[0] - uv[1]), uv[0]};
      }
      return;
    case ShapeKind::kTensor:
      if (way == 0) {
        rearrange(Shape::tensor(old.m, old.n), [&](int i, int j) { return Indices{j, i}; });
        std::swap(uv[0], uv[1]);
      } else {
        rearrange(old, [&](int i, int j) { return Indices{old.n - i, j}; });
        uv[0] = 1 - uv[0];
      }
  }
}

template <class Change>
void change_coordinates(Case& value, const Change& change) {
  for (MovingPatch<double>& patch : value.query.patches) {
    for (Points<double>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<double>& p : *points) change(p);
    }
  }
}

bool reverse_time(Case& value) {
  const Dyadic end = Dyadic::exact(value.query.t_max);
  for (MovingPatch<double>& patch : value.query.patches) {
    const auto at_end = as_doubles(exact_patch<Dyadic>(patch).at(end));
    if (!at_end) return false;
    patch.positions = *at_end;
    for (Vec3<double>& v : patch.velocities) v = -v;
  }
  value.truth.witness->t = end.rational() - value.truth.witness->t;
  return true;
}

bool elevate(Case& value, std::size_t side) {
  const Shape shape = value.query.patches[side].shape;
  if (shape.n >= kMaxDegree || shape.m >= kMaxDegree) return false;
  const int factor = shape.kind == ShapeKind::kPoint ? 1 : (shape.n + 1) * (shape.m + 1);
  for (std::size_t s = 0; s < 2; ++s) {
    MovingPatch<Dyadic> patch = exact_patch<Dyadic>(value.query.patches[s]);
    for (Points<Dyadic>* points : {&patch.positions, &patch.velocities}) {
      if (s == side) {
        Elevated<Dyadic> higher = elevated(shape, *points);
        if (shape.kind == ShapeKind::kTensor) higher = elevated(higher.shape, higher.points, true);
        *points = std::move(higher.points);
        patch.shape = higher.shape;
      } else {
        for (Vec3<Dyadic>& p : *points) p *= Dyadic(factor);
      }
    }
    const auto doubles = as_doubles(patch);
    if (!doubles) return false;
    value.query.patches[s] = *doubles;
  }
  return true;
}

/// Where a point of the patch lies on the part over a cell that holds it.
Uv<Rational> local_parameters(const Shape& shape, const Cell& cell, const Uv<Rational>& uv) {
  Uv<Rational> local;
  const std::array<std::uint64_t, 2> corner = {cell.i, cell.j};
  for (int k = 0; k < shape.parameter_count(); ++k) {
    const auto c = static_cast<std::size_t>(k);
    const Rational offset =
        uv[c] * power_of_two(cell.depth) - Rational(static_cast<unsigned long>(corner[c]));
    local[c] = cell.inverted ? Rational(1 - offset) : offset;
  }
  return local;
}

bool cut(Case& value, std::size_t side, Draw& choices) {
  MovingPatch<double>& patch = value.query.patches[side];
  Uv<Rational>& uv = value.truth.witness->uv[side];
  Cell cell;
  for (std::int64_t depth = choices.integer(1, 3); depth > 0; --depth) {
    const auto turn = static_cast<int>(choices.choose(3));
    for (int c = 0; c < patch.shape.child_count(); ++c) {
      const Cell child = cell.child(patch.shape, (c + turn) % patch.shape.child_count());
      if (!contains(child, patch.shape, uv)) continue;
      cell = child;
      break;
    }
  }
  if (patch.shape.kind == ShapeKind::kPoint) return true;
  const auto part = part_over(patch, cell);
  if (!part) return false;
  uv = local_parameters(patch.shape, cell, uv);
  patch = *part;
  return true;
}

}  // namespace

std::optional<MovingPatch<double>> part_over(const MovingPatch<double>& patch, const Cell& cell) {
  return as_doubles(
      restrict_to(exact_patch<Dyadic>(patch), exact_corners<Dyadic>(cell.corners(patch.shape))));
}

std::optional<Case> transformed(const Case& value, Symmetry symmetry, Draw& choices) {
  Case out = value;
  out.truth = Truth();
  out.truth.collides = true;
  out.truth.witness = value.truth.witness;
  out.expect.clear();
  const std::size_t side = choices.choose(1);
  const auto vector = [&] {
    Vec3<double> v;
    for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(choices.integer(-256, 256));
    return v;
  };
  switch (symmetry) {
    case Symmetry::kSwapPatches:
      std::swap(out.query.patches[0], out.query.patches[1]);
      std::swap(out.truth.witness->uv[0], out.truth.witness->uv[1]);
      break;
    case Symmetry::kReverseParameters:
      reverse_parameters(out.query.patches[side], out.truth.witness->uv[side], choices.choose(1));
      break;
    case Symmetry::kPermuteAxes: {
      const bool odd = choices.coin();
      change_coordinates(out, [&](Vec3<double>& p) {
        p = odd ? Vec3<double>(p[1], p[0], p[2]) : Vec3<double>(p[1], p[2], p[0]);
      });
      break;
    }
    case Symmetry::kMirror: {
      const auto k = static_cast<int>(choices.choose(2));
      change_coordinates(out, [&](Vec3<double>& p) { p[k] = -p[k]; });
      break;
    }
    case Symmetry::kScale:
      return similar(out, {.space = static_cast<int>(choices.integer(-60, 60))});
    case Symmetry::kScaleTime:
      return similar(out, {.time = static_cast<int>(choices.integer(-60, 60))});
    case Symmetry::kTranslate:
      return similar(out, {.shift = vector()});
    case Symmetry::kCommonVelocity:
      return similar(out, {.drift = vector()});
    case Symmetry::kReverseTime:
      if (!reverse_time(out)) return std::nullopt;
      break;
    case Symmetry::kElevate:
      if (!elevate(out, side)) return std::nullopt;
      break;
    case Symmetry::kPart:
      if (!cut(out, side, choices)) return std::nullopt;
  }
  return out;
}

}  // namespace ccdfuzz
