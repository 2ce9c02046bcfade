
#include <gtest/gtest.h>

#include "ccd/nearest_points.hpp"
#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {
namespace {

MovingPatch<double> body(Points<double> points, const Vec3<double>& velocity, double radius = 0) {
  MovingPatch<double> hull{
      Shape::hull(static_cast<int>(points.size())), std::move(points), {velocity}};
  hull.radius = radius;
  return hull;
}

Points<double> box(double x, double y, double z) {
  Points<double> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z);
  return points;
}

/// How long after clear_until the witness comes, relative to its time.
double bracket_of(const Truth& truth) {
  const Rational width = truth.witness->t - truth.clear_until.value_or(0);
  return truth.witness->t == 0 ? 0 : Rational(width / truth.witness->t).get_d();
}

TEST(DecideBodies, ABallThatGrazesAnEdgeTouchesIt) {
  // Its centre passes at (5, 5, ·) along z, and the corner (2, 1, 0) is 5 away: exactly, and not.
  const auto passes = [](double radius) {
    return decide({{body({{2, 1, 0}}, {0, 0, 0}), body({{5, 5, -3}}, {0, 0, 1}, radius)}, 8}).truth;
  };
  EXPECT_EQ(passes(5).collides, true);
  EXPECT_EQ(passes(5).witness->t, Rational(3));
  EXPECT_LE(bracket_of(passes(5)), 0x1p-16) << "the way to it is flat";
  EXPECT_EQ(passes(5 - 0x1p-50).collides, false);
}

TEST(DecideBodies, AnEndCountsAndAMissIsProvenByOneDirection) {
  Query query = {{body(box(1, 1, 1), {0, 0, 0}), body(box(1, 1, 1), {2, 0, 0})}, 1};
  for (Vec3<double>& p : query.patches[1].positions) p[0] -= 4;
  EXPECT_EQ(decide(query).truth.collides, true);
  EXPECT_EQ(decide(query).truth.witness->t, Rational(1));
  query.t_max = 1 - 0x1p-53;
  EXPECT_EQ(decide(query).truth.collides, false);
  query.separation = 0x1p-51;
  EXPECT_EQ(decide(query).truth.collides, true);
  query.t_max = 0;
  EXPECT_EQ(decide(query).truth.collides, false);
}

TEST(DecideTurning, DistancesWhoseSquaresAreNoDoublesAreDecided) {
  for (const double scale : {0x1p-1060, 0x1p-600, 0x1p600, 0x1p1000}) {
    Query query = {{body({{0, 0, 0}}, {0, 0, 0}), body({{scale, 0, 0}}, {0, 0, 0})}, 1};
    query.patches[0].turn = BodyTurn{{}, {}, {0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(decide(query).truth.collides, false) << scale;
    query.patches[1].positions[0][0] = 0;
    EXPECT_EQ(decide(query).truth.collides, true) << scale;
  }
}

TEST(NearestPoints, OfHullsThatMeetAreAtNoDistance) {
  NearestPoints nearest;
  const Points<Rational> square = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}};
  const NearestPoints::Found& apart = nearest(square, {{3, 1, 1}, {1, 1, 5}});
  EXPECT_EQ(apart.squared, Rational(2));
  EXPECT_EQ(apart.weights[1], (std::vector<Rational>{1, 0}));
  const NearestPoints::Found& crossed = nearest(square, {{1, 1, -1}, {1, 1, 5}});
  EXPECT_EQ(crossed.squared, 0);
  EXPECT_EQ(crossed.weights[1], (std::vector<Rational>{Rational(5, 6), Rational(1, 6)}));
}

}  // namespace
}  // namespace ccdfuzz
