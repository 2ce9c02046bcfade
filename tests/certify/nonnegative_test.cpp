#include "certify/checker/nonnegative.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

std::vector<Rational> numbers(std::initializer_list<int> values) {
  return {values.begin(), values.end()};
}

TEST(Nonnegative, IsSeenOfSquaresOnEveryShape) {
  EXPECT_TRUE(is_nonnegative(Shape::curve(2), numbers({1, -1, 1})));      // (2u − 1)²
  EXPECT_TRUE(is_nonnegative(Shape::curve(3), numbers({3, -1, -1, 3})));  // 3(2u − 1)²
  EXPECT_TRUE(is_nonnegative(Shape::tensor(2, 1), numbers({1, 1, -1, -1, 1, 1})));
  // 4(u − ½)² + 4(v − ½)², positive except in the middle
  EXPECT_TRUE(is_nonnegative(Shape::tensor(2, 2), numbers({2, 0, 2, 0, -2, 0, 2, 0, 2})));
  EXPECT_FALSE(is_nonnegative(Shape::tensor(2, 2), numbers({2, 0, 2, 0, -3, 0, 2, 0, 2})));
  // 3(2v − 1)² along the edge u = 0 of a cubic triangle, positive off it
  EXPECT_TRUE(is_nonnegative(Shape::triangle(3), numbers({3, -1, -1, 3, 1, 1, 1, 1, 1, 1})));
  EXPECT_FALSE(is_nonnegative(Shape::triangle(3), numbers({3, -2, -2, 3, 1, 1, 1, 1, 1, 1})));
}

TEST(Nonnegative, IsAMatterOfTheOneCoefficientOfAPoint) {
  EXPECT_TRUE(is_nonnegative(Shape::point(), numbers({0})));
  EXPECT_FALSE(is_nonnegative(Shape::point(), numbers({-1})));
}

}  // namespace
}  // namespace ccdfuzz
