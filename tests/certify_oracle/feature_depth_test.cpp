#include "certify/oracle/feature_depth.hpp"

#include <gtest/gtest.h>

#include "certify/oracle/oracle.hpp"
#include "meeting_points.hpp"

namespace ccdfuzz {
namespace {

Case falling_through() {
  Case known;
  known.query = falling_vertex();
  known.truth = decide(known.query).truth;
  return known;
}

void expect_feature_depth(const Case& known, double until, double depth) {
  const double found = feature_depth(known, until);
  EXPECT_LE(found, depth);
  EXPECT_GE(found, depth * (1 - 0x1p-40)) << found << " until " << until;
}

TEST(FeatureDepth, IsTheWayToTheNearestEdgeOrToTheEndOfTheMotion) {
  const Case known = falling_through();
  expect_feature_depth(known, 1, 0.25);
  expect_feature_depth(known, 0.5 + 0x1p-5, 0x1p-4);
  expect_feature_depth(known, 0.5, 0);
}

TEST(FeatureDepth, OfTwoEdgesTheyPassByTheNearestEnd) {
  Case known;
  known.query.patches[0] = {Shape::curve(1), {{-1, 0, 1}, {1, 0, 1}}, {{0, 0, -2}, {0, 0, -2}}};
  known.query.patches[1] = {Shape::curve(1), {{0, -0.5, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  known.truth = decide(known.query).truth;
  expect_feature_depth(known, 1, 0.5);
}

TEST(FeatureDepth, AtASeparationIsHowMuchNearerThePointsCome) {
  Case known;
  known.query.patches[0] = {Shape::point(), {{0.25, 0, 1}}, {{0, 0, -2}}};
  known.query.patches[1] = {Shape::curve(1), {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  known.query.t_max = 0.4375;
  known.query.separation = 0.5;
  known.truth.witness = Witness{Rational(1, 4), {}};
  known.truth.witness->uv[1][0] = Rational(1, 4);
  known.truth.collides = true;
  expect_feature_depth(known, 0.4375, 0.375);
  expect_feature_depth(known, 0.375, 0.25);
  expect_feature_depth(known, 1, 0.5);
  EXPECT_EQ(feature_depth(known, 0.25), 0);
}

TEST(FeatureDepth, AtASeparationIsThatManyTimesAsMuchAtEveryScale) {
  for (const double scale : {0x1p-1000, 0x1p-540, 0x1p540, 0x1p1000}) {
    Case known;
    known.query.patches[0] = {Shape::point(), {{0.375 * scale, 0, scale}}, {{0, 0, -2 * scale}}};
    known.query.patches[1] = {Shape::point(), {{0, 0, 0}}, {{0, 0, 0}}};
    known.query.separation = 0.625 * scale;
    known.truth = decide(known.query).truth;
    expect_feature_depth(known, 1, 0.25 * scale);
  }
}

TEST(FeatureDepth, IsNoneOfAContactAtTheEdgeOfAFaceNorOfOtherQueries) {
  Case known = falling_through();
  known.query.patches[0].positions[0][0] = 0;
  known.truth = decide(known.query).truth;
  EXPECT_EQ(feature_depth(known, 1), 0);
  known.query.patches[1] = {Shape::point(), {{0, 0.25, 0}}, {{0, 0, 0}}};
  known.truth = decide(known.query).truth;
  EXPECT_EQ(feature_depth(known, 1), 0) << "two points";
  known = falling_through();
  known.query.patches[1].trim = {{{0, 0}, {0.5, 0}, {0, 0.5}}};
  EXPECT_EQ(feature_depth(known, 1), 0) << "a part of a face";
  known = falling_through();
  known.truth = {};
  EXPECT_EQ(feature_depth(known, 1), 0) << "nothing is known of a contact";
}

}  // namespace
}  // namespace ccdfuzz
