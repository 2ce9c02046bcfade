#include "bezier/cell.hpp"

#include <cmath>

#include "base/verify.hpp"

namespace ccdfuzz {

Cell Cell::child(const Shape& shape, int c) const {
  CCDFUZZ_ASSERT(0 <= c && c < shape.child_count() && depth < kMaxDepth);
  const std::uint64_t c0 = static_cast<std::uint64_t>(c) & 1,
                      c1 = static_cast<std::uint64_t>(c) >> 1;
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  // Three children of a triangle keep the parent's orientation and one of its corners each; the
  // middle one turns.
  if (shape.kind == ShapeKind::kTriangle && c == 3) {
    const std::uint64_t half = inverted ? 1 : 0;
    return {2 * i + half, 2 * j + half, depth + 1, !inverted};
  }
  if (inverted) return {2 * i + 1 - c0, 2 * j + 1 - c1, depth + 1, true};
  return {2 * i + c0, 2 * j + c1, depth + 1, false};
}

std::array<Uv<double>, 3> Cell::corners(const Shape& shape) const {
  const auto at = [this](std::uint64_t a) { return std::ldexp(static_cast<double>(a), -depth); };
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  const int parameters = shape.parameter_count();
  const Uv<double> lo = {at(i), at(j)},
                   hi = {parameters > 0 ? at(i + 1) : 0, parameters > 1 ? at(j + 1) : 0};
  if (shape.kind != ShapeKind::kTriangle) return {{lo, hi, {}}};
  const Uv<double> low_v = {hi[0], lo[1]}, low_u = {lo[0], hi[1]};
  return inverted ? std::array{hi, low_u, low_v} : std::array{lo, low_v, low_u};
}

Uv<double> Cell::centre(const Shape& shape) const {
  const std::array<Uv<double>, 3> c = corners(shape);
  if (shape.kind == ShapeKind::kTriangle) {
    return {(c[0][0] + c[1][0] + c[2][0]) / 3, (c[0][1] + c[1][1] + c[2][1]) / 3};
  }
  return {(c[0][0] + c[1][0]) / 2, (c[0][1] + c[1][1]) / 2};
}

}  // namespace ccdfuzz
