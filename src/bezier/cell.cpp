#include "bezier/cell.hpp"

#include <cmath>

#include "base/verify.hpp"

namespace ccdfuzz {

Cell Cell::child(const Shape& shape, int c) const {
  CCDFUZZ_ASSERT(0 <= c && c < shape.child_count() && depth < kMaxDepth);
  const std::uint64_t c0 = static_cast<std::uint64_t>(c) & 1,
                      c1 = static_cast<std::uint64_t>(c) >> 1;
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return {0, 0, depth + 1, false};
    case ShapeKind::kCurve:
      return {2 * i + c0, 0, depth + 1, false};
    case ShapeKind::kTensor:
      return {2 * i + c0, 2 * j + c1, depth + 1, false};
    case ShapeKind::kTriangle:
      break;
  }
  // Three children keep the parent's orientation and one of its corners each; the middle one turns.
  if (!inverted) {
    if (c == 3) return {2 * i, 2 * j, depth + 1, true};
    return {2 * i + c0, 2 * j + c1, depth + 1, false};
  }
  if (c == 3) return {2 * i + 1, 2 * j + 1, depth + 1, false};
  return {2 * i + 1 - c0, 2 * j + 1 - c1, depth + 1, true};
}

std::array<Uv<double>, 3> Cell::corners(const Shape& shape) const {
  const auto at = [this](std::uint64_t a) { return std::ldexp(static_cast<double>(a), -depth); };
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return {};
    case ShapeKind::kCurve:
      return {{{at(i), 0}, {at(i + 1), 0}, {}}};
    case ShapeKind::kTensor:
      return {{{at(i), at(j)}, {at(i + 1), at(j + 1)}, {}}};
    case ShapeKind::kTriangle:
      break;
  }
  if (inverted) return {{{at(i + 1), at(j + 1)}, {at(i), at(j + 1)}, {at(i + 1), at(j)}}};
  return {{{at(i), at(j)}, {at(i + 1), at(j)}, {at(i), at(j + 1)}}};
}

Uv<double> Cell::centre(const Shape& shape) const {
  const std::array<Uv<double>, 3> c = corners(shape);
  if (shape.kind == ShapeKind::kTriangle) {
    return {(c[0][0] + c[1][0] + c[2][0]) / 3, (c[0][1] + c[1][1] + c[2][1]) / 3};
  }
  return {(c[0][0] + c[1][0]) / 2, (c[0][1] + c[1][1]) / 2};
}

}  // namespace ccdfuzz
