#include <fmt/format.h>

#include <algorithm>

#include "bezier/elevate.hpp"
#include "bezier/restrict.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "generators/draw_patch.hpp"
#include "numeric/products.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

constexpr int kGeometryDegree = 4, kGeometryUvBits = 4;

struct DrawnPatch {
  Shape shape;
  Points<Dyadic> points;
  Uv<Dyadic> uv;

  Check fails(const std::string& what) const {
    return Check::fails(
        fmt::format("{} {} at {}: {}", to_text(shape), to_text(points), to_text(uv), what));
  }
};

DrawnPatch draw_patch(Draw& choices) {
  DrawnPatch drawn;
  drawn.shape = draw_shape(choices, kGeometryDegree);
  drawn.uv = draw_uv(choices, drawn.shape, kGeometryUvBits);
  drawn.points = draw_points(choices, drawn.shape, 10, -4);
  return drawn;
}

/// Section 4.6, the assumption that the patch lies in the hull of its control points: on any axis
/// its height is between the least and the greatest of theirs.
Check check_convex_hull(Draw& choices) {
  const DrawnPatch drawn = draw_patch(choices);
  const Vec3<Dyadic> axis{choices.dyadic(6, 0), choices.dyadic(6, 0), choices.dyadic(6, 0)};
  const Dyadic height = dot(axis, evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv));
  Dyadic least = dot(axis, drawn.points[0]), most = least;
  for (const Vec3<Dyadic>& p : drawn.points) {
    const Dyadic h = dot(axis, p);
    if (h < least) least = h;
    if (most < h) most = h;
  }
  return least <= height && height <= most ? Check::holds() : drawn.fails("it is out of the hull");
}

/// The Bernstein weights sum to 1: common translation of the control points moves each point of
/// the patch so.
Check check_partition_of_unity(Draw& choices) {
  const DrawnPatch drawn = draw_patch(choices);
  const Vec3<Dyadic> shift{choices.dyadic(8, -2), choices.dyadic(8, -2), choices.dyadic(8, -2)};
  Points<Dyadic> moved = drawn.points;
  for (Vec3<Dyadic>& p : moved) p += shift;
  const Vec3<Dyadic> before = evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv);
  const Vec3<Dyadic> after = evaluate<Dyadic>(drawn.shape, moved, drawn.uv);
  return after == Vec3<Dyadic>(before + shift) ? Check::holds() : drawn.fails("it moved otherwise");
}

/// The blossom does not depend on the order of its arguments.
Check check_blossom_symmetry(Draw& choices) {
  const DrawnPatch drawn = draw_patch(choices);
  const auto steps = static_cast<std::size_t>(std::max(drawn.shape.n, drawn.shape.m));
  std::vector<Uv<Dyadic>> arguments(std::max<std::size_t>(steps, 1));
  for (Uv<Dyadic>& argument : arguments) argument = draw_uv(choices, drawn.shape, kGeometryUvBits);
  const Vec3<Dyadic> first = blossom<Dyadic>(drawn.shape, drawn.points, arguments);
  const auto turn = static_cast<std::ptrdiff_t>(choices.choose(arguments.size() - 1));
  // Of a tensor patch with n ≠ m the first n and the first m count: only those change places.
  const auto common = drawn.shape.kind == ShapeKind::kTensor
                          ? static_cast<std::ptrdiff_t>(std::min(drawn.shape.n, drawn.shape.m))
                          : static_cast<std::ptrdiff_t>(arguments.size());
  std::rotate(arguments.begin(), arguments.begin() + std::min(turn, common),
              arguments.begin() + common);
  return blossom<Dyadic>(drawn.shape, drawn.points, arguments) == first
             ? Check::holds()
             : drawn.fails("another order of the arguments gives another blossom");
}

/// Degree elevation gives the same patch.
Check check_elevation(Draw& choices) {
  const DrawnPatch drawn = draw_patch(choices);
  const Vec3<Dyadic> here = evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv);
  for (const bool in_v : {false, true}) {
    if (in_v && drawn.shape.kind != ShapeKind::kTensor) break;
    const Elevated<Dyadic> higher = elevated(drawn.shape, drawn.points, in_v);
    if (evaluate<Dyadic>(higher.shape, higher.points, drawn.uv) != here * Dyadic(higher.times)) {
      return drawn.fails("the patch of a higher degree is elsewhere");
    }
  }
  return Check::holds();
}

/// A point of a cell is a point of one of its children, and of nothing but the cell.
Check check_children_cover(Draw& choices) {
  const Shape shape = draw_shape(choices, 1);
  const Cell cell = draw_cell(choices, shape, 8);
  const Uv<Dyadic> drawn = draw_uv(choices, shape, 10);
  const Uv<Rational> uv{drawn[0].rational(), drawn[1].rational()};
  bool in_a_child = false;
  for (int c = 0; c < shape.child_count(); ++c) {
    in_a_child = in_a_child || cell.child(shape, c).contains(shape, uv);
  }
  // A point stands for itself and is its own child.
  if (in_a_child == cell.contains(shape, uv)) return Check::holds();
  return Check::fails(fmt::format("{}, cell i = {}, j = {}, depth = {}, inverted = {}, at {}: {}",
                                  to_text(shape), cell.i, cell.j, cell.depth, cell.inverted,
                                  to_text(drawn), in_a_child ? "in a child alone" : "in no child"));
}

/// The midpoint splits of tdibm-c and the blossoms of the others agree, where both are exact.
Check check_cell_tree(Draw& choices) {
  const Shape shape = draw_shape(choices, kGeometryDegree);
  const Points<Dyadic> points = draw_points(choices, shape, 10, 0);
  std::vector<std::array<double, 6>> controls;
  for (const Vec3<Dyadic>& p : points) {
    std::array<double, 6> c{};
    for (int k = 0; k < 3; ++k) c[static_cast<std::size_t>(k)] = *p[k].to_double_exactly();
    controls.push_back(c);
  }
  certified::CellTree tree;
  tree.reset(shape, controls);
  certified::CellTree::Node node = 0;
  // 10 bits and a bit a degree and level fit 53.
  for (std::int64_t depth = choices.integer(0, 4); depth > 0; --depth) {
    node = tree.children(node) + static_cast<certified::CellTree::Node>(choices.choose(
                                     static_cast<std::uint64_t>(shape.child_count()) - 1));
  }
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, exact_corners<Dyadic>(tree.cell(node).corners(shape)), part);
  for (std::size_t i = 0; i < part.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = tree.net(node)[certified::kPerPoint * static_cast<int>(i) + k];
      if (Dyadic::exact(x) == part[i][k]) continue;
      return Check::fails(fmt::format("{} {}: control point {} at depth {}", to_text(shape),
                                      to_text(points), i, tree.cell(node).depth));
    }
  }
  return Check::holds();
}

}  // namespace

std::vector<Property> geometry_claims() {
  constexpr auto kHolds = Expectation::kHolds;
  return {
      {"patch.convex_hull", "A patch lies in the convex hull of its control points",
       "Section 4.6, Assumptions", kHolds, check_convex_hull},
      {"patch.partition_of_unity", "Moving all control points alike moves the patch so", "Eq. 2",
       kHolds, check_partition_of_unity},
      {"patch.blossom_symmetry", "The blossom does not depend on the order of its arguments",
       "Appendix A (b)", kHolds, check_blossom_symmetry},
      {"patch.elevation", "A patch of one degree higher is the same patch", "Eq. 2", kHolds,
       check_elevation},
      {"cell.children_cover", "The children of a cell cover it, and nothing else", "Appendix A (a)",
       kHolds, check_children_cover},
      {"cell.trees_agree",
       "Repeated midpoint splits give the control points of the blossom at the cell's corners",
       "src/ccd/certified/DERIVATION.md", kHolds, check_cell_tree},
  };
}

}  // namespace ccdfuzz
