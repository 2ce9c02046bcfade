#include "bezier/cell.hpp"
#include "bezier/exact_patch.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

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
