// The ground of a hunt: what lies in all domains, what is drawn on it, and what is brought there.
#include "hunt/ground.hpp"

#include <gtest/gtest.h>

#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "hunt/draw.hpp"
#include "method/method.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

constexpr Domain::Pair kVertexFace = {{{ShapeKind::kPoint, 0}, {ShapeKind::kTriangle, 1}}};
constexpr Domain::Pair kEdgeEdge = {{{ShapeKind::kCurve, 1}, {ShapeKind::kCurve, 1}}};

/// As an adapter of vertices, faces and edges promises.
HuntGround ground_of_features() {
  HuntGround ground;
  ground.pairs = {kVertexFace, kEdgeEdge};
  ground.scale = 10;
  ground.ordinary = true;
  return ground;
}

/// As an adapter of a physics engine promises that has balls, and solids without a radius.
HuntGround ground_of_an_engine() {
  HuntGround ground;
  ground.bodies = ground.binary32 = ground.ordinary = true;
  ground.scale = 7;
  ground.body_kinds = {{1, 1, RadiusRule::kPositive}, {4, 12, RadiusRule::kZero}};
  return ground;
}

/// The share of draws of which something is asked. All that is asked lies on the ground, with a
/// truth that the checker accepts.
double share_used(const HuntGround& ground, const Features& features = {}) {
  const Draws draws(1, ground, features);
  double used = 0, all = 0;
  for (const ContactClass contact : draws.classes()) {
    for (std::uint64_t index = 0; index < 240 / kOneIn; ++index) {
      const std::vector<CheckedCase> drawn = draws.at(contact, index);
      ++all;
      used += drawn.empty() ? 0 : 1;
      for (const CheckedCase& asked : drawn) {
        EXPECT_TRUE(ground.has(asked.value()));
        EXPECT_TRUE(check_case(asked.value()));
        EXPECT_TRUE(asked.value().truth.collides.has_value());
      }
    }
  }
  return used / all;
}

TEST(Ground, FloatsAreWeightsAndLoopsToo) {
  HuntGround ground;
  ground.binary32 = true;
  Case value;
  for (MovingPatch<double>& patch : value.query.patches) {
    patch = {Shape::curve(2), Points<double>(3, {1, 0, 0}), Points<double>(3, {0, 1, 0})};
    patch.weights = {1, 0.5, 1};
  }
  EXPECT_TRUE(ground.has(value));
  value.query.patches[1].weights[1] = 0.1;
  EXPECT_FALSE(ground.has(value));
  value.query.patches[1] = {Shape::triangle(1), Points<double>(3, {0, 0, 1}),
                            Points<double>(3, {0, 1, 0})};
  value.query.patches[1].trim = {{{0, 0}, {0, 0.1}, {0.5, 0}}};
  EXPECT_FALSE(ground.has(value));
}

TEST(Ground, DrawsAreMadeOnItRatherThanDiscarded) {
  EXPECT_GE(share_used(ground_of_an_engine()), 0.95);
  EXPECT_GE(share_used(ground_of_features()), 0.8);
  EXPECT_GE(share_used(ground_of_features(), {.separation = true}), 0.7);
  HuntGround floats = ground_of_features();
  floats.binary32 = true;
  EXPECT_GE(share_used(floats), 0.65);
  HuntGround linear;
  linear.linear = linear.ordinary = true;
  EXPECT_GE(share_used(linear), 0.65);
}

TEST(Ground, ClassesAreThoseOfTheShapesThatAreTaken) {
  using enum ContactClass;
  HuntGround ground = ground_of_features();
  EXPECT_EQ(Draws(1, ground).classes(), (std::vector{kEE, kVF})) << "those that are deep";
  ground.ordinary = false;
  EXPECT_EQ(Draws(1, ground).classes(), (std::vector{kEE, kVF, kVE, kVV}));
  ground.pairs = {kEdgeEdge};
  EXPECT_EQ(Draws(1, ground).classes(), (std::vector{kEE, kVE, kVV}));
  ground.linear = true;
  EXPECT_EQ(Draws(1, ground).classes(), std::vector{kEE}) << "degenerate ones, by shapes";
}

TEST(Ground, DegreesAreThoseThatAreTaken) {
  HuntGround ground;
  ground.pairs = {{{{ShapeKind::kTensor, 8}, {ShapeKind::kTriangle, 2}}}};
  const std::vector<ShapePair> drawn = ground.drawn_shapes();
  EXPECT_EQ(drawn.size(), 10U) << "three degrees, two also of one less in v, in either order";
  EXPECT_EQ(drawn[6], (ShapePair{Shape::tensor(3, 3), Shape::triangle(2)}));
}

TEST(Ground, UniformDrawsAreDecidedAndSomeTouch) {
  for (HuntGround ground : {ground_of_features(), ground_of_an_engine()}) {
    ground.uniform = true;
    const Draws draws(1, ground);
    EXPECT_EQ(draws.classes().size(), ground.bodies ? 6U : 2U) << "classes by shapes";
    int touching = 0, all = 0;
    for (std::uint64_t index = 0; index < 200; ++index) {
      for (const CheckedCase& asked : draws.at(draws.classes()[0], index)) {
        EXPECT_TRUE(ground.has(asked.value()));
        ++all;
        touching += asked.collides().value() ? 1 : 0;
      }
    }
    EXPECT_GT(all, 50);
    EXPECT_GT(touching, all / 50) << all;
  }
}

TEST(Ground, FloatsHaveATruthOfTheirOwn) {
  Case known;
  known.query.patches[0] = {Shape::point(), {{0.25, 0.25, 0.1}}, {{0, 0, -1}}};
  known.query.patches[1] = {Shape::triangle(1),
                            {{0, 0, 0}, {0, 1, 0}, {1, 0, 0x1p-40}},
                            {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  HuntGround ground;
  ground.binary32 = true;
  ground.scale = 10;
  const Case fitted = ground.fitted(known);
  EXPECT_TRUE(ground.has(fitted));
  EXPECT_EQ(fitted.query.patches[1].positions[2][2], 0);
  EXPECT_EQ(fitted.truth.witness->t, exact(static_cast<double>(0.1F)));
  known.query.patches[1].weights = {1, 0.1, 1};
  const Case weighted = ground.fitted(known);
  EXPECT_TRUE(ground.has(weighted));
  EXPECT_EQ(weighted.query.patches[1].weights[1], 0.1F);
  EXPECT_TRUE(check_case(weighted));
  known.query.patches[1].weights = {1, 0x1p-40, 1};
  EXPECT_EQ(ground.fitted(known), fitted) << "a weight that is 0 is none";
  known.query.t_max = 0;
  known.query.patches[0].shape = Shape::curve(2);
  EXPECT_EQ(ground.fitted(known), known) << "of curves the truth may be unknown";
}

TEST(Ground, PatchesStayWithinTheScale) {
  Case known;
  known.query.patches.fill({Shape::point(), {{100, 0, 0}}, {{27, 0, 0}}});
  HuntGround ground;
  ground.scale = 7;
  EXPECT_EQ(ground.broken_by(known), "");
  known.query.t_max = 2;
  EXPECT_EQ(ground.broken_by(known), "takes patches whose points are within 2^7 at t_max, too");
}

TEST(Ground, WhatNoMethodTakesIsAnError) {
  EXPECT_TRUE(narrowed({}, {"tdibm-c", "oracle"}));
  HuntGround bodies;
  bodies.bodies = true;
  EXPECT_TRUE(narrowed(bodies, {"oracle"}));
  const auto none = narrowed(bodies, {"oracle", "tdibm-c"});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message(),
            "methods: no query is taken by all of oracle, tdibm-c: hunt them apart");
}

TEST(Ground, IsOfBodiesForAPluginThatTakesThemAndNamesNoShapes) {
  const std::string of_all = "plugin:" CCDFUZZ_TEST_CLAIMING_PLUGIN ":verdict=2:claims=70",
                    bodies = "plugin:" CCDFUZZ_TEST_CLAIMING_PLUGIN ":verdict=2:claims=326",
                    patches = "plugin:" CCDFUZZ_TEST_CLAIMING_PLUGIN ":verdict=2";
  for (const auto& plugin : {of_all, bodies, patches}) ASSERT_TRUE(admit_plugin(plugin));
  EXPECT_FALSE(narrowed({}, {of_all})->bodies) << "it limits neither bodies nor numbers";
  EXPECT_TRUE(narrowed({}, {bodies})->bodies);
  EXPECT_TRUE(narrowed({}, {bodies, "oracle"})->bodies);
  EXPECT_FALSE(narrowed({}, {bodies, "tdibm-c"})->bodies);
  EXPECT_FALSE(narrowed({}, {patches})->bodies);
  EXPECT_FALSE(narrowed({}, {"oracle"})->bodies) << "it takes all shapes";
  HuntGround linear;
  linear.linear = true;
  EXPECT_FALSE(narrowed(linear, {bodies})->bodies);
}

TEST(Domain, CommonPartsAreNoWiderThanEither) {
  Domain some, others;
  some.pairs = {kVertexFace, {{{ShapeKind::kTensor, 2}, {ShapeKind::kTensor, 8}}}};
  some.scale = 7;
  some.body_kinds = {{1, 8, RadiusRule::kAny}};
  others.pairs = {{{{ShapeKind::kTriangle, 3}, {ShapeKind::kPoint, 0}}}};
  others.scale = 10;
  others.binary32 = true;
  others.body_kinds = {{4, 12, RadiusRule::kZero}};
  for (const auto& both : {some.with(others), others.with(some)}) {
    ASSERT_TRUE(both);
    ASSERT_EQ(both->pairs.size(), 1U);
    EXPECT_EQ(std::max(both->pairs[0][0].max_degree, both->pairs[0][1].max_degree), 1U);
    EXPECT_EQ(both->scale, 7);
    EXPECT_TRUE(both->binary32);
    ASSERT_EQ(both->body_kinds.size(), 1U);
    EXPECT_TRUE(both->body_kinds[0].has(4, false) && both->body_kinds[0].has(8, false));
    EXPECT_FALSE(both->body_kinds[0].has(3, false) || both->body_kinds[0].has(9, false));
    EXPECT_FALSE(both->body_kinds[0].has(8, true));
  }
  others.pairs = {kEdgeEdge};
  EXPECT_FALSE(some.with(others));
}

}  // namespace
}  // namespace ccdfuzz
