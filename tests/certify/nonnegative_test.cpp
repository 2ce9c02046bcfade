#include "certify/checker/nonnegative.hpp"

#include <gmock/gmock.h>

#include <random>

#include "bezier/patch.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

std::vector<Rational> numbers(std::initializer_list<int> values) {
  return {values.begin(), values.end()};
}

/// The polynomial of these coefficients at (u, v), from its definition (Shape).
Rational value_at(const Shape& shape, const std::vector<Rational>& c, const Rational& u,
                  const Rational& v) {
  const auto power = [](const Rational& x, int k) {
    Rational p = 1;
    for (int i = 0; i < k; ++i) p *= x;
    return p;
  };
  const auto choose = [](int n, int k) {
    int value = 1;
    for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
    return value;
  };
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  Rational sum = 0;
  for (int i = 0; i <= shape.n; ++i) {
    const int m = triangle ? shape.n - i : shape.m;
    for (int j = 0; j <= m; ++j) {
      const Rational rest = triangle ? power(1 - u - v, m - j)
                                     : Rational(power(1 - u, shape.n - i) * power(1 - v, m - j));
      sum += c[static_cast<size_t>(shape.index(i, j))] * choose(shape.n, i) * choose(m, j) *
             power(u, i) * power(v, j) * rest;
    }
  }
  return sum;
}

constexpr std::array kShapes = {Shape::curve(2),     Shape::curve(3),     Shape::triangle(1),
                                Shape::triangle(2),  Shape::triangle(3),  Shape::tensor(1, 1),
                                Shape::tensor(2, 1), Shape::tensor(2, 2), Shape::tensor(1, 3)};

TEST(Nonnegative, IsNeverSaidOfWhatIsNegativeSomewhere) {
  std::mt19937_64 random(1);
  int accepted = 0, with_negative_coefficients = 0;
  for (const Shape& shape : kShapes) {
    for (int round = 0; round < 600 / static_cast<int>(kOneIn); ++round) {
      std::vector<Rational> c;
      bool negative = false;
      for (int i = 0; i < shape.control_count(); ++i) {
        c.emplace_back(static_cast<int>(random() % 12) - 2);
        negative |= c.back() < 0;
      }
      if (!is_nonnegative(shape, c)) continue;
      ++accepted;
      with_negative_coefficients += negative;
      for (int i = 0; i <= 16; ++i) {
        for (int j = 0; j <= 16; ++j) {
          const Rational u(i, 16), v(j, 16);
          if (shape.contains(Uv<Rational>{u, shape.parameter_count() == 2 ? v : Rational(0)})) {
            ASSERT_GE(value_at(shape, c, u, v), 0) << to_text(shape) << " " << u << " " << v;
          }
        }
      }
    }
  }
  EXPECT_GT(accepted, 500 / static_cast<int>(kOneIn));
  EXPECT_GT(with_negative_coefficients, 100 / static_cast<int>(kOneIn));
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

// A row of a triangle along each of its edges.
TEST(Nonnegative, IsSeenAlongAnyEdge) {
  EXPECT_TRUE(is_nonnegative(Shape::triangle(3), numbers({3, 1, 1, 1, -1, 1, 1, -1, 1, 3})));
  EXPECT_TRUE(is_nonnegative(Shape::triangle(3), numbers({1, 1, 1, 3, 1, 1, -1, 1, -1, 3})));
  EXPECT_TRUE(is_nonnegative(Shape::tensor(1, 2), numbers({1, -1, 1, 5, 5, 5})));
  EXPECT_TRUE(is_nonnegative(Shape::tensor(2, 1), numbers({1, 5, -1, 5, 1, 5})));
}

// (2v − 1)²·(1 + u²) + (2u − 1)²·(2 + v), which is 0 in the middle alone.
TEST(Nonnegative, IsSeenOfASumOfSquaresThatVaryAlong) {
  const auto at = [](int i, int j) {
    constexpr std::array<int, 3> kSquare = {1, -1, 1};  // of (2x − 1)²
    const Rational one_and_square = i == 2 ? 2 : 1, two_and_more = 2 + Rational(j, 2);
    return Rational(kSquare.at(static_cast<size_t>(j)) * one_and_square +
                    kSquare.at(static_cast<size_t>(i)) * two_and_more);
  };
  std::vector<Rational> c;
  for (int i = 0; i <= 2; ++i) {
    for (int j = 0; j <= 2; ++j) c.push_back(at(i, j));
  }
  const Shape shape = Shape::tensor(2, 2);
  EXPECT_EQ(value_at(shape, c, Rational(1, 2), Rational(1, 2)), 0);
  EXPECT_TRUE(is_nonnegative(shape, c));
  for (Rational& x : c) x -= power_of_two(-60);
  EXPECT_FALSE(is_nonnegative(shape, c));
}

TEST(Nonnegative, IsAMatterOfTheOneCoefficientOfAPoint) {
  EXPECT_TRUE(is_nonnegative(Shape::point(), numbers({0})));
  EXPECT_FALSE(is_nonnegative(Shape::point(), numbers({-1})));
}

}  // namespace
}  // namespace ccdfuzz
