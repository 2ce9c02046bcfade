#include "bezier/shape.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace ccdfuzz {
namespace {

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes = {Shape::point()};
  for (int n = 1; n <= kMaxDegree; ++n) {
    shapes.push_back(Shape::curve(n));
    shapes.push_back(Shape::triangle(n));
    for (int m = 1; m <= kMaxDegree; ++m) shapes.push_back(Shape::tensor(n, m));
  }
  return shapes;
}

TEST(Shape, IndexCountsTheControlPointsInOrder) {
  for (const Shape& shape : all_shapes()) {
    ASSERT_TRUE(shape.valid()) << to_text(shape);
    int next = 0;
    const int rows = shape.kind == ShapeKind::kPoint ? 0 : shape.n;
    for (int i = 0; i <= rows; ++i) {
      const int columns = shape.kind == ShapeKind::kTriangle ? shape.n - i
                          : shape.kind == ShapeKind::kTensor ? shape.m
                                                             : 0;
      for (int j = 0; j <= columns; ++j) EXPECT_EQ(shape.index(i, j), next++) << to_text(shape);
    }
    EXPECT_EQ(next, shape.control_count()) << to_text(shape);
    EXPECT_LE(next, kMaxControls);
  }
}

TEST(Shape, DomainsAreClosed) {
  using Uv = std::array<double, 2>;
  EXPECT_TRUE(Shape::point().contains(Uv{0, 0}));
  EXPECT_FALSE(Shape::point().contains(Uv{0.5, 0}));
  EXPECT_TRUE(Shape::curve(1).contains(Uv{1, 0}));
  EXPECT_FALSE(Shape::curve(1).contains(Uv{1, 0.5}));
  EXPECT_TRUE(Shape::triangle(1).contains(Uv{0.5, 0.5}));
  EXPECT_FALSE(Shape::triangle(1).contains(Uv{0.5, 0.75}));
  EXPECT_TRUE(Shape::tensor(1, 1).contains(Uv{1, 1}));
  EXPECT_FALSE(Shape::tensor(1, 1).contains(Uv{-0.25, 1}));
}

}  // namespace
}  // namespace ccdfuzz
