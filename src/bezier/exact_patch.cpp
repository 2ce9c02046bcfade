#include "bezier/exact_patch.hpp"

namespace ccdfuzz {

bool contains(const Cell& cell, const Shape& shape, const Uv<Rational>& uv) {
  const Rational unit = power_of_two(cell.depth);
  const Rational x = uv[0] * unit - Rational(Integer(static_cast<unsigned long>(cell.i)));
  const Rational y = uv[1] * unit - Rational(Integer(static_cast<unsigned long>(cell.j)));
  if (shape.kind == ShapeKind::kHull) refuse_hull();
  if (shape.kind != ShapeKind::kTriangle) return 0 <= x && x <= 1 && 0 <= y && y <= 1;
  return cell.inverted ? x <= 1 && y <= 1 && x + y >= 1 : x >= 0 && y >= 0 && x + y <= 1;
}

}  // namespace ccdfuzz
