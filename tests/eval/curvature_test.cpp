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

/// Of principal curvatures a and b.
double rms(double a, double b) {
  return std::sqrt((a * a + b * b) / 2);
}

TEST(Curvature, IsTheHessianOfAGraphAtItsFlatPoint) {
  EXPECT_DOUBLE_EQ(rms_curvature(graph(3, 0, 1, 0.25), {0, 0}, 2).value(), rms(6, 2));
  EXPECT_DOUBLE_EQ(rms_curvature(graph(-1, 0, 0.5, 4), {0, 0}, 2).value(), rms(-2, 1));
  EXPECT_DOUBLE_EQ(rms_curvature(graph(1, 0, 1, 4), {0, 0}, 2).value(), 2);
  EXPECT_EQ(rms_curvature(graph(0, 0, 0, 1), {Rational(1, 4), Rational(1, 4)}, 2), 0);
}

// z = x²: the curvature along x at any point is 2/(1 + 4x²)^(3/2), the other one 0.
TEST(Curvature, IsRightForACylinderAwayFromItsVertex) {
  const auto at = rms_curvature(graph(1, 0, 0, 1), {Rational(1, 2), Rational(1, 4)}, 2);
  EXPECT_NEAR(at.value(), rms(2 / std::pow(2.0, 1.5), 0), 1e-14);
}

TEST(Curvature, IsTheSameForATensorPatchAndItsTriangle) {
  // z = x·y over the unit square: bilinear.
  const MovingPatch<double> patch{Shape::tensor(1, 1),
                                  {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}},
                                  Points<double>(4, {0, 0, 0})};
  EXPECT_DOUBLE_EQ(rms_curvature(patch, {0, 0}, 0).value(), 1);
  const auto same = rms_curvature(graph(0, 1, 0, 1), {Rational(1, 2), Rational(1, 4)}, 2);
  const auto there = rms_curvature(patch, {Rational(1, 2), Rational(1, 4)}, 0);
  EXPECT_NEAR(same.value(), there.value(), 1e-14);
}

TEST(Curvature, CurvesPointsAndCollapsedPatchesHaveNone) {
  const MovingPatch<double> curve{
      Shape::curve(1), {{0, 0, 0}, {1, 0, 0}}, Points<double>(2, {0, 0, 0})};
  EXPECT_FALSE(rms_curvature(curve, {0, 0}, 0));
  EXPECT_FALSE(rms_curvature(graph(1, 1, 1, 0), {0, 0}, 2));
}

}  // namespace
}  // namespace ccdfuzz
