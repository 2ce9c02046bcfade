#include "eval/curvature.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

/// At t = 2 the graph of z = a·x² + b·x·y + c·y², with x = size·u and y = size·v, over the triangle
/// (0,0), (1,0), (0,1) of (u, v). Before, it moves along.
MovingPatch<double> graph(double a, double b, double c, double size) {
  const double s = size * size;
  MovingPatch<double> patch{Shape::triangle(2),
                            {{0, 0, 0},
                             {0, size / 2, 0},
                             {0, size, c * s},
                             {size / 2, 0, 0},
                             {size / 2, size / 2, b * s / 2},
                             {size, 0, a * s}},
                            Points<double>(6, {1, -3, 0.5})};
  for (Vec3<double>& p : patch.positions) p -= 2 * Vec3<double>(1, -3, 0.5);
  return patch;
}

TEST(Curvature, IsTheHessianOfAGraphAtItsFlatPoint) {
  const auto bowl = curvature_at(graph(3, 0, 1, 0.25), {0, 0}, 2);
  ASSERT_TRUE(bowl);
  EXPECT_DOUBLE_EQ(bowl->kappa[0], 6);
  EXPECT_DOUBLE_EQ(bowl->kappa[1], 2);
  EXPECT_DOUBLE_EQ(bowl->rms(), std::sqrt(20.0));
  const auto saddle = curvature_at(graph(-1, 0, 0.5, 4), {0, 0}, 2);
  EXPECT_DOUBLE_EQ(saddle->kappa[0], -2);
  EXPECT_DOUBLE_EQ(saddle->kappa[1], 1);
  const auto plane = curvature_at(graph(0, 0, 0, 1), {Rational(1, 4), Rational(1, 4)}, 2);
  EXPECT_EQ(plane->rms(), 0);
}

// z = x²: the curvature along x at any point is 2/(1 + 4x²)^(3/2), the other one 0.
TEST(Curvature, IsRightForACylinderAwayFromItsVertex) {
  const auto at = curvature_at(graph(1, 0, 0, 1), {Rational(1, 2), Rational(1, 4)}, 2);
  EXPECT_NEAR(at->kappa[0], 2 / std::pow(2.0, 1.5), 1e-14);
  EXPECT_NEAR(at->kappa[1], 0, 1e-14);
}

TEST(Curvature, IsTheSameForATensorPatchAndItsTriangle) {
  // z = x·y over the unit square: bilinear.
  const MovingPatch<double> patch{Shape::tensor(1, 1),
                                  {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}},
                                  Points<double>(4, {0, 0, 0})};
  const auto saddle = curvature_at(patch, {0, 0}, 0);
  ASSERT_TRUE(saddle);
  EXPECT_DOUBLE_EQ(std::abs(saddle->kappa[0]), 1);
  EXPECT_DOUBLE_EQ(saddle->kappa[0], -saddle->kappa[1]);
  const auto same = curvature_at(graph(0, 1, 0, 1), {Rational(1, 2), Rational(1, 4)}, 2);
  const auto there = curvature_at(patch, {Rational(1, 2), Rational(1, 4)}, 0);
  EXPECT_NEAR(same->rms(), there->rms(), 1e-14);
}

TEST(Curvature, CurvesPointsAndCollapsedPatchesHaveNone) {
  const MovingPatch<double> curve{
      Shape::curve(1), {{0, 0, 0}, {1, 0, 0}}, Points<double>(2, {0, 0, 0})};
  EXPECT_FALSE(curvature_at(curve, {0, 0}, 0));
  EXPECT_FALSE(curvature_at(graph(1, 1, 1, 0), {0, 0}, 2));
}

}  // namespace
}  // namespace ccdfuzz
