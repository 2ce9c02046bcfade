#include <algorithm>

#include "bezier/elevate.hpp"
#include "bezier/exact_patch.hpp"
#include "bezier/restrict.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "generators/draw_patch.hpp"
#include "numeric/products.hpp"
#include "properties/property.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr int kGeometryDegree = 4, kGeometryUvBits = 4;

struct DrawnPatch {
  Shape shape;
  Points<Dyadic> points;
  Uv<Dyadic> uv;
};

DrawnPatch draw_patch(Draw& d) {
  DrawnPatch drawn;
  drawn.shape = draw_shape(d, kGeometryDegree);
  drawn.uv = draw_uv(d, drawn.shape, kGeometryUvBits);
  drawn.points = draw_points(d, drawn.shape, 10, -4);
  show(d, "shape", drawn.shape);
  show(d, "uv", drawn.uv);
  show(d, "points", drawn.points);
  return drawn;
}

/// On any axis its height is between the least and the greatest of theirs.
void check_convex_hull(Draw& d) {
  const DrawnPatch drawn = draw_patch(d);
  const Vec3<Dyadic> axis{d.dyadic(6, 0), d.dyadic(6, 0), d.dyadic(6, 0)};
  const Dyadic height = dot(axis, evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv));
  Dyadic least = dot(axis, drawn.points[0]), most = least;
  for (const Vec3<Dyadic>& p : drawn.points) {
    const Dyadic h = dot(axis, p);
    if (h < least) least = h;
    if (most < h) most = h;
  }
  show(d, "axis", axis);
  CLAIM(least <= height);
  CLAIM(height <= most);
}

/// Since the Bernstein weights sum to 1.
void check_partition_of_unity(Draw& d) {
  const DrawnPatch drawn = draw_patch(d);
  const Vec3<Dyadic> shift{d.dyadic(8, -2), d.dyadic(8, -2), d.dyadic(8, -2)};
  Points<Dyadic> moved = drawn.points;
  for (Vec3<Dyadic>& p : moved) p += shift;
  const Vec3<Dyadic> before = evaluate<Dyadic>(drawn.shape, drawn.points, drawn.uv);
  const Vec3<Dyadic> after = evaluate<Dyadic>(drawn.shape, moved, drawn.uv);
  show(d, "shift", shift);
  CLAIM(after == Vec3<Dyadic>(before + shift));
}

void check_blossom_symmetry(Draw& d) {
  const DrawnPatch drawn = draw_patch(d);
  const auto steps = static_cast<std::size_t>(std::max(drawn.shape.n, drawn.shape.m));
  std::vector<Uv<Dyadic>> arguments(std::max<std::size_t>(steps, 1));
  for (Uv<Dyadic>& argument : arguments) argument = draw_uv(d, drawn.shape, kGeometryUvBits);
  show(d, "arguments", arguments);
  const Vec3<Dyadic> first = blossom<Dyadic>(drawn.shape, drawn.points, arguments);
  const auto turn = static_cast<std::ptrdiff_t>(d.choose(arguments.size() - 1));
  // Of a tensor patch with n ≠ m the first n and the first m count: only those change places.
  const auto common = drawn.shape.kind == ShapeKind::kTensor
                          ? static_cast<std::ptrdiff_t>(std::min(drawn.shape.n, drawn.shape.m))
                          : static_cast<std::ptrdiff_t>(arguments.size());
  std::rotate(arguments.begin(), arguments.begin() + std::min(turn, common),
              arguments.begin() + common);
  show(d, "turned", arguments);
  CLAIM(blossom<Dyadic>(drawn.shape, drawn.points, arguments) == first);
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
  const Shape shape = draw_shape(d, 1);
  const Cell cell = draw_cell(d, shape, 8);
  const Uv<Dyadic> drawn = draw_uv(d, shape, 10);
  const Uv<Rational> uv{drawn[0].rational(), drawn[1].rational()};
  // A point is its own child.
  bool is_in_a_child = false;
  for (int c = 0; c < shape.child_count(); ++c) {
    is_in_a_child = is_in_a_child || contains(cell.child(shape, c), shape, uv);
  }
  show(d, "shape", shape);
  show(d, "cell", cell);
  show(d, "uv", drawn);
  CLAIM(is_in_a_child == contains(cell, shape, uv));
}

/// The midpoint splits of tdibm-c and the blossoms of the others agree, where both are exact.
void check_cell_tree(Draw& d) {
  const Shape shape = draw_shape(d, kGeometryDegree);
  const Points<Dyadic> points = draw_points(d, shape, 10, 0);
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
  for (std::int64_t depth = d.integer(0, 4); depth > 0; --depth) {
    node = tree.children(node) + static_cast<certified::CellTree::Node>(
                                     d.choose(static_cast<std::uint64_t>(shape.child_count()) - 1));
  }
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, exact_corners<Dyadic>(tree.cell(node).corners(shape)), part);
  show(d, "shape", shape);
  show(d, "cell", tree.cell(node));
  show(d, "points", points);
  for (std::size_t i = 0; i < part.size(); ++i) {
    show(d, "control point", i);
    for (int k = 0; k < 3; ++k) {
      const double x = tree.net(node)[certified::kPerPoint * static_cast<int>(i) + k];
      CLAIM(Dyadic::exact(x) == part[i][k]);
    }
  }
}

}  // namespace

std::vector<Property> geometry_claims() {
  return {
      {"patch.convex_hull", "A patch lies in the convex hull of its control points",
       "Section 4.6, Assumptions", check_convex_hull},
      {"patch.partition_of_unity", "Moving all control points alike moves the patch so", "Eq. 2",
       check_partition_of_unity},
      {"patch.blossom_symmetry", "The blossom does not depend on the order of its arguments",
       "Appendix A (b)", check_blossom_symmetry},
      {"patch.elevation", "A patch of one degree higher is the same patch", "Eq. 2",
       check_elevation},
      {"cell.children_cover", "The children of a cell cover it, and nothing else", "Appendix A (a)",
       check_children_cover},
      {"cell.trees_agree",
       "Repeated midpoint splits give the control points of the blossom at the cell's corners",
       "src/ccd/certified/DERIVATION.md", check_cell_tree},
  };
}

}  // namespace ccdfuzz
