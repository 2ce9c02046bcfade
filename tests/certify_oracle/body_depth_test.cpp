#include "certify/oracle/body_depth.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ccdfuzz {
namespace {

MovingPatch<double> box(const Vec3<double>& low, const Vec3<double>& high,
                        const Vec3<double>& velocity) {
  Points<double> corners;
  for (const double x : {low[0], high[0]}) {
    for (const double y : {low[1], high[1]}) {
      for (const double z : {low[2], high[2]}) corners.push_back({x, y, z});
    }
  }
  return {Shape::hull(8), corners, {velocity}};
}

MovingPatch<double> ball(const Vec3<double>& centre, double radius, const Vec3<double>& velocity) {
  return {Shape::hull(1), {centre}, {velocity}, {}, {}, radius};
}

void expect_depth(const Query& query, double until, double depth) {
  const double found = depth_until(query, until).value();
  EXPECT_LE(found, depth);
  EXPECT_GE(found, depth * (1 - 0x1p-40)) << found << " until " << until;
}

TEST(BodyDepth, IsTheWayOfABallBeyondItsContactWithABox) {
  const Query query{{ball({-4, 3, 0.5}, 1, {0, -1, 0}), box({-5, -1, -5}, {5, 1, 5}, {0, 0, 0})},
                    8};
  expect_depth(query, 1, 0);
  expect_depth(query, 1.25, 0.25);
  expect_depth(query, 2.5, 1.5);
  // It has passed through. The nearest way out is over the edge at x = −5, by its radius more.
  expect_depth(query, 8, 2);
}

TEST(BodyDepth, IsTheLeastOverlapOfTheMotionOfTwoBoxes) {
  Query query{{box({0, 0, 0}, {1, 1, 1}, {4, 0, 0}), box({3, 0.25, 0.5}, {4, 5, 5}, {0, 0, 0})}, 1};
  expect_depth(query, 0.5, 0);
  expect_depth(query, 0.5625, 0.25);
  expect_depth(query, 1, 0.5);  // down, as the overlap in z is less than that in y
  query.separation = 0.125;
  expect_depth(query, 1, 0.625);
}

TEST(BodyDepth, ScalesWithTheBodies) {
  for (const int power : {-1000, -700, 700, 1000}) {
    const double unit = std::ldexp(1, power);
    Query boxes{{box({0, 0, 0}, {2, 2, 2}, {1, 0, 0}), box({4, 1, 0}, {6, 3, 2}, {0, 0, 0})}, 1};
    Query balls{{ball({0, 0, 0}, 1, {2, 0, 0}), ball({4, 0, 0}, 1, {0, 0, 0})}, 1};
    for (Query* query : {&boxes, &balls}) {
      for (MovingPatch<double>& body : query->patches) {
        for_each_coordinate(body, [&](double& x) { x *= unit; });
      }
    }
    expect_depth(boxes, 4, unit);
    expect_depth(balls, 1.25, unit / 2);
  }
}

TEST(BodyDepth, GrowsWithTimeAndNeverExceedsTheWay) {
  const Query query{
      {MovingPatch<double>{
           Shape::hull(4), {{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0.25}, {0.5, 0.5, 1}}, {{0.5, 0.25, 2}}},
       ball({1, 1, 3}, 0.5, {0, 0, -1})},
      2};
  double last = 0;
  for (double until = 0; until <= 2; until += 0.125) {
    const double depth = depth_until(query, until).value();
    EXPECT_GE(depth, last);
    EXPECT_LE(depth, last + 0.125 * std::sqrt(0.25 + 0.0625 + 9));
    last = depth;
  }
  EXPECT_GT(last, 0.25);
}

TEST(BodyDepth, InAPlaneIsTheLeastWayThere) {
  const Query query{
      {MovingPatch<double>{
           Shape::hull(4), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{4, 0, 0}}},
       MovingPatch<double>{Shape::hull(3), {{3, 0.25, 0}, {6, 0.25, 0}, {3, 4, 0}}, {{0, 0, 0}}}},
      1};
  EXPECT_EQ(depth_until(query, 0.75), 0.0) << "out of the plane, any way is far enough";
  const double depth = depth_until(query, 0.75, true).value();
  EXPECT_LE(depth, 0.75);
  EXPECT_GE(depth, 0.75 * (1 - 0x1p-40)) << "down";
}

TEST(BodyDepth, OfWhatHasNoInsideIsNothing) {
  const Query query{{ball({0, 0, 1}, 0, {0, 0, -2}), ball({0, 0, 0}, 0, {0, 0, 0})}, 1};
  expect_depth(query, 1, 0);
}

TEST(BodyDepth, IsALowerBoundWhereTheCentreOfASpinIsFarAway) {
  Query query{{ball({0, 0, 0}, 1, {0, 0, 0}), ball({0, 1.5, 0}, 1, {0, 0, 0})}, 1};
  BodyTurn& turn = query.patches[0].turn.emplace();
  turn.spin = {0, 0, -0x1.8p-143};
  turn.centre = {0x1p100, 0, 0};
  EXPECT_LE(depth_until(query, 1).value(), 0.5 + 0x1.8p-43) << "it moves no farther than that";
}

}  // namespace
}  // namespace ccdfuzz
