#include "bezier/bernstein.hpp"
#include "bezier/elevate.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "generators/draw_patch.hpp"
#include "generators/shaped/features.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr int kGeometryDegree = 4, kGeometryUvBits = 4;

struct DrawnPatch {
  Shape shape;
  Points<Dyadic> points;
  Uv<Dyadic> uv;
};

DrawnPatch draw_patch(Draw& d, int max_degree = kGeometryDegree) {
  DrawnPatch drawn;
  drawn.shape = draw_shape(d, max_degree);
  drawn.uv = draw_uv(d, drawn.shape, kGeometryUvBits);
  drawn.points = draw_points(d, drawn.shape, 10, -4);
  show(d, "shape", drawn.shape);
  show(d, "uv", drawn.uv);
  show(d, "points", drawn.points);
  return drawn;
}

/// By the definition of the weights, which blossoms are not computed by. It follows that a patch
/// lies in the convex hull of its control points, and moves as they do.
void check_bernstein_sum(Draw& d) {
  const DrawnPatch drawn = draw_patch(d, kMaxDegree);
  const std::vector<Dyadic> weights = bernstein_weights(drawn.shape, drawn.uv);
  Dyadic total;
  Vec3<Dyadic> sum;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    CLAIM(weights[i].sign() >= 0);
    total += weights[i];
    sum += drawn.points[i] * weights[i];
  }
  CLAIM(total == Dyadic(1));
  CLAIM(sum == evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv));
}

void check_elevation(Draw& d) {
  const DrawnPatch drawn = draw_patch(d);
  const Vec3<Dyadic> here = evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv);
  for (const bool in_v : {false, true}) {
    if (in_v && drawn.shape.kind != ShapeKind::kTensor) break;
    const Elevated<Dyadic> higher = elevated(drawn.shape, drawn.points, in_v);
    const Vec3<Dyadic> there = evaluate<Dyadic>(higher.shape, higher.points, drawn.uv);
    show(d, "elevated to", higher.shape);
    CLAIM(there == here * Dyadic(higher.times));
  }
}

void check_children_cover(Draw& d) {
  const Shape shape = show(d, "shape", draw_shape(d, 1));
  const Cell cell = show(d, "cell", draw_cell(d, shape, 8));
  const Uv<Dyadic> drawn = show(d, "uv", draw_uv(d, shape, 10));
  const Uv<Rational> uv{drawn[0].rational(), drawn[1].rational()};
  // A point is its own child.
  bool is_in_a_child = false;
  for (int c = 0; c < shape.child_count(); ++c) {
    is_in_a_child = is_in_a_child || contains(cell.child(shape, c), shape, uv);
  }
  CLAIM(is_in_a_child == contains(cell, shape, uv));
}

void check_sub_patch(Draw& d) {
  constexpr int kDegree = 5;  // the cost of tensor patches grows with its sixth power
  const auto [shape, points, uv] = draw_patch(d, kDegree);
  const Cell cell = show(d, "cell", draw_cell(d, shape, 8));
  const auto corners = exact_corners<Dyadic>(cell.corners(shape));
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, corners, part);
  const Uv<Dyadic> global = on_whole(shape, corners, uv);
  CLAIM(evaluate<Dyadic>(shape, part, uv) == evaluate<Dyadic>(shape, points, global));
}

}  // namespace

std::vector<Property> geometry_claims() {
  return {
      {"patch.bernstein_sum",
       "A patch is the sum of its control points by Bernstein weights, which are >= 0 and sum to 1",
       "Eq. 2; Section 4.6, Assumptions", check_bernstein_sum},
      {"patch.elevation", "A patch of one degree higher is the same patch", "Eq. 2",
       check_elevation},
      {"cell.children_cover", "The children of a cell cover it, and nothing else", "Appendix A (a)",
       check_children_cover},
      {"sub_patch.is_the_restriction", "The sub-patch over a cell equals the patch there, exactly",
       "Appendix A (b)", check_sub_patch},
  };
}

}  // namespace ccdfuzz
