#include "bezier/cell.hpp"

#include "bezier/exact_patch.hpp"
#include "bezier/random_patch.hpp"
#include "bezier/restrict.hpp"

namespace ccdfuzz {
namespace {

Cell any_cell(const Shape& shape, int max_depth = 6) {
  Cell cell;
  for (int d = *rc::gen::inRange(0, max_depth + 1); d > 0; --d) {
    cell = cell.child(shape, *rc::gen::inRange(0, shape.child_count()));
  }
  return cell;
}

/// The global parameters of local parameters `uv` of a cell.
Uv<Dyadic> to_global(const Shape& shape, const std::array<Uv<Dyadic>, 3>& c, const Uv<Dyadic>& uv) {
  const auto& [u, v] = uv;
  Uv<Dyadic> g;
  for (size_t k = 0; k < 2; ++k) {
    if (shape.kind == ShapeKind::kTriangle) {
      g[k] = (Dyadic(1) - u - v) * c[0][k] + u * c[1][k] + v * c[2][k];
    } else {
      const Dyadic& x = k == 0 ? u : v;
      g[k] = (Dyadic(1) - x) * c[0][k] + x * c[1][k];
    }
  }
  return g;
}

RC_GTEST_PROP(SubPatch, EqualsTheRestrictionExactly, ()) {
  const Shape shape = *any_shape();
  const Points<Dyadic> points = any_points(shape);
  const auto corners = exact_corners<Dyadic>(any_cell(shape).corners(shape));
  Points<Dyadic> part(points.size());
  restrict_to<Dyadic>(shape, points, corners, part);
  const Uv<Dyadic> local = any_uv(shape);
  RC_ASSERT(evaluate<Dyadic>(shape, part, local) ==
            evaluate<Dyadic>(shape, points, to_global(shape, corners, local)));
}

RC_GTEST_PROP(Cell, ChildrenCoverTheParentAndNothingElse, ()) {
  const Shape shape = *any_shape();
  const Cell parent = any_cell(shape);
  const Uv<Dyadic> local = any_uv(shape);
  const Uv<Dyadic> g = to_global(shape, exact_corners<Dyadic>(parent.corners(shape)), local);
  const Uv<Rational> uv = {g[0].rational(), g[1].rational()};
  RC_ASSERT(contains(parent, shape, uv));
  bool covered = false;
  for (int c = 0; c < shape.child_count(); ++c) {
    const Cell child = parent.child(shape, c);
    covered = covered || contains(child, shape, uv);
    for (const Uv<double>& corner : child.corners(shape)) {
      if (shape.kind != ShapeKind::kTriangle) break;
      RC_ASSERT(contains(parent, shape, {exact(corner[0]), exact(corner[1])}));
    }
  }
  RC_ASSERT(covered);
}

TEST(Cell, CornersAreExactAtTheDeepestLevel) {
  for (const Shape shape : {Shape::curve(1), Shape::triangle(1), Shape::tensor(1, 1)}) {
    Cell cell;
    while (cell.depth < Cell::kMaxDepth) cell = cell.child(shape, shape.child_count() - 1);
    const auto c = cell.corners(shape);
    EXPECT_TRUE(contains(cell, shape, {exact(c[0][0]), exact(c[0][1])})) << to_text(shape);
    EXPECT_NE(c[0][0], c[1][0]) << to_text(shape);
  }
}

}  // namespace
}  // namespace ccdfuzz
