#include "properties/sub_patch.hpp"

#include <fmt/format.h>

#include "bezier/restrict.hpp"
#include "generators/draw_patch.hpp"

namespace ccdfuzz {

namespace {

/// What local parameters of a cell stand for.
Uv<Dyadic> to_global(const Shape& shape, const std::array<Uv<Dyadic>, 3>& corners,
                     const Uv<Dyadic>& uv) {
  const auto& [u, v] = uv;
  Uv<Dyadic> global;
  for (std::size_t k = 0; k < 2; ++k) {
    if (shape.kind == ShapeKind::kTriangle) {
      global[k] = (Dyadic(1) - u - v) * corners[0][k] + u * corners[1][k] + v * corners[2][k];
    } else {
      const Dyadic& x = uv[k];
      global[k] = (Dyadic(1) - x) * corners[0][k] + x * corners[1][k];
    }
  }
  return global;
}

}  // namespace

Check sub_patch_is_the_restriction(const Shape& shape, const Points<Dyadic>& points,
                                   const Cell& cell, const Uv<Dyadic>& uv) {
  const auto corners = exact_corners<Dyadic>(cell.corners(shape));
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, corners, part);
  const Uv<Dyadic> global = to_global(shape, corners, uv);
  if (evaluate<Dyadic>(shape, part, uv) == evaluate<Dyadic>(shape, points, global)) {
    return Check::holds();
  }
  return Check::fails(fmt::format(
      "{} {} over cell i = {}, j = {}, depth = {}, inverted = {}: sub-patch at {} is not "
      "the patch at {}",
      to_text(shape), to_text(points), cell.i, cell.j, cell.depth, cell.inverted, to_text(uv),
      to_text(global)));
}

Check check_sub_patch_is_the_restriction(Draw& choices) {
  constexpr int kDegree = 5;  // the cost of exact tensor patches grows with its sixth power
  const Shape shape = draw_shape(choices, kDegree);
  const Cell cell = draw_cell(choices, shape, 8);
  const Uv<Dyadic> uv = draw_uv(choices, shape, 4);
  const Points<Dyadic> points = draw_points(choices, shape, 12, -6);
  return sub_patch_is_the_restriction(shape, points, cell, uv);
}

}  // namespace ccdfuzz
