#include "files/engine_test.hpp"

#include <gmock/gmock.h>

namespace ccdfuzz {
namespace {

/// A ball of radius 1 that falls onto a side of a box, which it touches at t = 1.
NamedCase falling_ball() {
  NamedCase named;
  named.id = "ball.json";
  Query& query = named.value.query;
  query.patches[0] = {Shape::hull(1), {{-4, 3, 0.5}}, {{0, -1, 0}}, {}, {}, 1};
  query.patches[1] = {
      Shape::hull(4), {{-5, -1, -5}, {-5, -1, 5}, {-5, 1, -5}, {-5, 1, 5}}, {{0, 0, 0}}};
  query.t_max = 1;
  named.value.truth.collides = true;
  named.value.truth.witness = Witness{Rational(1), {}};
  named.value.truth.witness->weights = {{{1}, {0, 0, 1, 0}}};
  return named;
}

/// The centre of a ball of radius 1, at (distance, 0, 0), turns about 0. At t = 3/7 its x is down
/// to `x`, and it touches a segment on the line at x - 1.
NamedCase turning_ball(const BodyTurn& turn, double distance, double x) {
  NamedCase named;
  Query& query = named.value.query;
  query.t_max = 1;
  query.patches[0] = {Shape::hull(1), {{distance, 0, 0}}, {{0, 0, 0}}, {}, {}, 1};
  query.patches[0].turn = turn;
  query.patches[1] = {Shape::hull(2), {{x - 1, 0, 0}, {x - 1, 32, 0}}, {{0, 0, 0}}};
  named.value.truth.collides = true;
  named.value.truth.witness = Witness{Rational(3, 7), {}};
  named.value.truth.witness->weights = {{{1}, {Rational(1, 4), Rational(3, 4)}}};
  const std::array<Rational, 3> normal = {1, 0, 0};
  named.value.truth.clearance = BodyPlanes{Rational(3, 7), {{0, {normal, normal}, {}, {}}}};
  return named;
}

TEST(EngineTest, AllowsBodiesThatTurnToComeAsDeepAsTheToleranceIs) {
  // They turn by 49/25 radians a unit of time, and by twice that, where |q| is 5/7.
  const NamedCase by_angle = turning_ball({{1, 0}, {0, 1}}, 5, 4),
                  by_quaternion = turning_ball({{1, 0, 0, 0}, {0, 0, 0, 1}}, 25, 7);
  EXPECT_THAT(*engine_test(by_angle, "box2d"), testing::HasSubstr("fraction <= 0.4296343537"))
      << "3/7 + 0.00625 / (3 · 49/25)";
  EXPECT_THAT(*engine_test(by_quaternion, "box3d"), testing::HasSubstr("fraction <= 0.4286378613"))
      << "3/7 + 0.00625 / (24 · 98/25)";
}

TEST(EngineTest, TurnsBodiesAsTheEngineDoesOrRefusesThem) {
  NamedCase named = falling_ball();
  Query& query = named.value.query;
  const auto refused = [&](const std::string& engine) {
    return engine_test(named, engine).error().message() ==
           "ball.json: " + engine + " has no tests of such turns";
  };
  query.patches[1].turn = BodyTurn{{}, {}, {1, 0, 0}, {0, 0, 0.25}};
  EXPECT_THAT(*engine_test(named, "bullet"),
              testing::AllOf(testing::HasSubstr("0, btVector3(1, 0, 0));"),
                             testing::HasSubstr("btQuaternion(btVector3(0, 0, 0.25), 0.25)")));
  EXPECT_THAT(
      *engine_test(named, "fcl-bodies"),
      testing::AllOf(testing::HasSubstr("V(1, 0, 0), V(1, 0, 0), 0.25, V(0, 0, 0.25))"),
                     testing::HasSubstr("motion(V(-4, 3, 0.5), V(-4, 3, 0.5), V(-4, 3, 0.5)")));
  EXPECT_TRUE(refused("rapier"));
  EXPECT_TRUE(refused("box3d"));
  query.patches[1].turn = BodyTurn{{1, 0, 0, 0}, {0.6, 0, 0, 0.8}};
  EXPECT_THAT(*engine_test(named, "box3d"), testing::HasSubstr(".q2 = { { 0, 0, 0.8 }, 0.6 }"));
  EXPECT_TRUE(refused("bullet"));
  query.patches[1].turn->to = {1, 0, 0, 1};
  EXPECT_TRUE(refused("box3d")) << "it needs quaternions of unit length";
  query.patches[1].turn = BodyTurn{{1, 0}, {0.6, 0.8}};
  EXPECT_TRUE(refused("box3d"));
  for (MovingPatch<double>& patch : query.patches) {
    for (Vec3<double>& p : patch.positions) p[2] = 0;
  }
  EXPECT_THAT(*engine_test(named, "box2d"), testing::HasSubstr(".q2 = { 0.6, 0.8 }"));
}

}  // namespace
}  // namespace ccdfuzz
