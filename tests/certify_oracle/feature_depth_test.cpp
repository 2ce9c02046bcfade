#include "certify/oracle/feature_depth.hpp"

#include <gtest/gtest.h>

#include "certify/oracle/oracle.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

/// A vertex that falls through a right triangle with legs of length 1.
Case falling_through() {
  Case known;
  known.query.patches[0] = {Shape::point(), {{0.25, 0.25, 1}}, {{0, 0, -2}}};
  known.query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  known.query.t_max = 1;
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

TEST(FeatureDepth, IsThatManyTimesAsMuchAtEveryScale) {
  for (const double scale : {0x1p-1000, 0x1p-540, 0x1p540, 0x1p1000}) {
    Case known = falling_through();
    for (MovingPatch<double>& patch : known.query.patches) {
      for (Vec3<double>& p : patch.positions) p *= scale;
      for (Vec3<double>& v : patch.velocities) v *= scale;
    }
    expect_feature_depth(known, 1, 0.25 * scale);
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

TEST(FeatureDepth, WhatIsMovedByLessStillTouches) {
  int deep = 0;
  for (const ContactClass contact : {ContactClass::kVF, ContactClass::kEE}) {
    GeneratorOptions options;
    options.contact = contact;
    options.construction = Construction::kOneSided;
    options.shapes = contact == ContactClass::kVF ? std::array{Shape::point(), Shape::triangle(1)}
                                                  : std::array{Shape::curve(1), Shape::curve(1)};
    for (std::uint64_t index = 0; index < 20; ++index) {
      Case known = generate(options, index).value;
      known.query.t_max *= 1.5;
      const double depth = feature_depth(known, known.query.t_max);
      if (depth > 0) ++deep;
      for (int way = 0; depth > 0 && way < 6; ++way) {
        Query moved = known.query;
        for (Vec3<double>& p : moved.patches[0].positions) {
          p[way / 2] += (way % 2 == 0 ? 0.99 : -0.99) * depth;
        }
        EXPECT_EQ(decide(moved).truth.collides, true) << name_of(contact) << " " << index;
      }
    }
  }
  EXPECT_GT(deep, 30);
}

}  // namespace
}  // namespace ccdfuzz
