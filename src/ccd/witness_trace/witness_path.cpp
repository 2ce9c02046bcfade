#include "ccd/witness_trace/witness_path.hpp"

namespace ccdfuzz {

WitnessPath::FixedPoint WitnessPath::fixed_point(const Rational& x) {
  const Rational scaled = x * power_of_two(Cell::kMaxDepth);
  const Integer units = scaled.get_num() / scaled.get_den();
  return {units.get_ui(), units != scaled};
}

void WitnessPath::assign(const std::array<Shape, 2>& shapes, const Witness& witness,
                         int time_exponent) {
  shapes_ = shapes;
  for (size_t side = 0; side < 2; ++side) {
    const Rational &u = witness.uv[side][0], &v = witness.uv[side][1];
    at_[side] = {fixed_point(u), fixed_point(v), fixed_point(u + v)};
  }
  const Rational t = witness.t * power_of_two(-time_exponent);
  time_ = {round_down(t), round_up(t)};
}

bool WitnessPath::in(int side, const Cell& cell) const {
  const auto& [u, v, sum] = at_[static_cast<size_t>(side)];
  const int d = cell.depth;
  const ShapeKind kind = shapes_[static_cast<size_t>(side)].kind;
  if (kind == ShapeKind::kHull) refuse_hull();
  if (kind != ShapeKind::kTriangle) {
    return u.at_least(cell.i, d) && u.at_most(cell.i + 1, d) && v.at_least(cell.j, d) &&
           v.at_most(cell.j + 1, d);
  }
  const std::uint64_t diagonal = cell.i + cell.j + 1;
  return cell.inverted
             ? u.at_most(cell.i + 1, d) && v.at_most(cell.j + 1, d) && sum.at_least(diagonal, d)
             : u.at_least(cell.i, d) && v.at_least(cell.j, d) && sum.at_most(diagonal, d);
}

}  // namespace ccdfuzz
