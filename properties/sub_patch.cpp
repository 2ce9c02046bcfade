#include "properties/sub_patch.hpp"

#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "generators/draw_patch.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// The parameters of the patch that local parameters of a cell mean.
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

void claim_sub_patch_is_the_restriction(const Shape& shape, const Points<Dyadic>& points,
                                        const Cell& cell, const Uv<Dyadic>& uv) {
  const auto corners = exact_corners<Dyadic>(cell.corners(shape));
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, corners, part);
  const Uv<Dyadic> global = to_global(shape, corners, uv);
  CLAIM(evaluate<Dyadic>(shape, part, uv) == evaluate<Dyadic>(shape, points, global));
}

std::vector<Property> sub_patch_claims() {
  return {{"sub_patch.is_the_restriction",
           "The sub-patch over a cell equals the patch there, exactly", "Appendix A (b)",
           [](Draw& d) {
             constexpr int kDegree = 5;  // the cost of tensor patches grows with its sixth power
             const Shape shape = draw_shape(d, kDegree);
             const Cell cell = draw_cell(d, shape, 8);
             const Uv<Dyadic> uv = draw_uv(d, shape, 4);
             const Points<Dyadic> points = draw_points(d, shape, 12, -6);
             show(d, "shape", shape);
             show(d, "points", points);
             show(d, "cell", cell);
             show(d, "uv", uv);
             claim_sub_patch_is_the_restriction(shape, points, cell, uv);
           }}};
}

}  // namespace ccdfuzz
