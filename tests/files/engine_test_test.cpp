#include "files/engine_test.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace ccdfuzz {
namespace {

/// A ball of radius 1 that falls onto a box, which it touches at t = 1, half of its way.
NamedCase falling_ball() {
  NamedCase named;
  named.id = "ball.json";
  Query& query = named.value.query;
  query.patches[0] = {Shape::hull(1), {{-4, 3, 0.5}}, {{0, -1, 0}}, {}, {}, 1};
  Points<double> corners;
  for (const double x : {-5., 5.}) {
    for (const double y : {-1., 1.}) {
      for (const double z : {-5., 5.}) corners.push_back({x, y, z});
    }
  }
  query.patches[1] = {Shape::hull(8), corners, {{0, 0, 0}}};
  query.t_max = 2;
  named.value.truth.collides = true;
  Witness witness{Rational(1), {}};
  witness.weights[0] = {Rational(1)};
  witness.weights[1] = std::vector<Rational>(8, Rational(0));
  witness.weights[1][2] = Rational(1);
  named.value.truth.witness = witness;
  return named;
}

NamedCase vertex_through_face() {
  NamedCase named;
  named.id = "vertex.json";
  Query& query = named.value.query;
  query.patches[0] = {Shape::point(), {{0.25, 0.25, 0.5}}, {{0, 0, -1}}};
  query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Points<double>(3, {0, 0, 0})};
  named.value.truth.collides = true;
  named.value.truth.witness = Witness{Rational(1, 2), {}};
  named.value.truth.witness->uv[1] = {Rational(1, 4), Rational(1, 4)};
  return named;
}

TEST(EngineTest, AsksEachEngineForTheShapesThatItHas) {
  const NamedCase ball = falling_ball();
  const std::vector<std::pair<std::string, std::string>> shapes = {
      {"rapier", "new RAPIER.Cuboid(5, 1, 5)"},
      {"jolt", "new Jolt.BoxShape(new Jolt.Vec3(5, 1, 5), 0)"},
      {"physx", "new physx.PxSphereGeometry(1)"},
      {"havok", "hk.HP_Shape_CreateBox([0, 0, 0], [0, 0, 0, 1], [10, 2, 10])"},
      {"bullet", "hull({btVector3(-4, 3, 0.5)}, 1)"}};
  for (const auto& [engine, shape] : shapes) {
    const Result<std::string> text = engine_test(ball, engine);
    ASSERT_TRUE(text.has_value()) << engine;
    EXPECT_THAT(*text, testing::HasSubstr(shape));
    EXPECT_THAT(*text, testing::HasSubstr("0.5"));
    EXPECT_THAT(*text, testing::StartsWith("// At t = 1 of t_max = 2"));
  }
  const Result<std::string> fcl = engine_test(vertex_through_face(), "fcl");
  ASSERT_TRUE(fcl.has_value());
  EXPECT_THAT(*fcl, testing::HasSubstr("intersect_VF(\n      V(0, 0, 0), V(0, 1, 0), V(1, 0, 0), "
                                       "V(0.25, 0.25, 0.5),\n"));
}

TEST(EngineTest, AllowsTheEnginesOwnTolerance) {
  const Result<std::string> in_space = engine_test(falling_ball(), "rapier");
  EXPECT_THAT(*in_space, testing::HasSubstr("assert(share <= 0.50005,")) << "1e-4 of a way of 2";
  const Result<std::string> in_time = engine_test(vertex_through_face(), "fcl");
  EXPECT_THAT(*in_time, testing::HasSubstr("EXPECT_LE(share, 0.5000001)"));
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

TEST(EngineTest, TakesACornerThatIsNoMiddleOfABoxForAHull) {
  NamedCase named = falling_ball();
  named.value.query.patches[1].positions[0][0] = -6;
  const Result<std::string> text = engine_test(named, "rapier");
  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, testing::HasSubstr("new RAPIER.ConvexPolyhedron("));
}

TEST(EngineTest, RefusesShapesThatTheEngineHasNot) {
  for (const char* engine : {"rapier", "jolt", "bullet"}) {
    EXPECT_FALSE(engine_test(vertex_through_face(), engine)) << engine;
  }
  EXPECT_EQ(engine_test(falling_ball(), "fcl").error().message(),
            "ball.json: fcl has no tests of bodies");
  NamedCase round = falling_ball();
  Points<double>& points = round.value.query.patches[0].positions;
  std::vector<Rational>& weights = round.value.truth.witness->weights[0];
  points.push_back({0, 3, 0});
  weights.emplace_back(0);
  round.value.query.patches[0].shape = Shape::hull(2);
  EXPECT_TRUE(engine_test(round, "jolt")) << "a capsule";
  points.push_back({1, 4, 0});
  weights.emplace_back(0);
  round.value.query.patches[0].shape = Shape::hull(3);
  EXPECT_FALSE(engine_test(round, "jolt")) << "a rounded triangle";
}

TEST(EngineTest, GivesAMeshSecondAndWithItsSides) {
  NamedCase named = falling_ball();
  Query& query = named.value.query;
  query.patches[1].faces = {{0, 2, 1}, {1, 2, 3}};
  std::swap(query.patches[0], query.patches[1]);
  std::swap(named.value.truth.witness->weights[0], named.value.truth.witness->weights[1]);
  const std::string ball = "const a = new RAPIER.Ball(1);\n",
                    faces = "Uint32Array([0, 2, 1, 1, 2, 3])";
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::AllOf(testing::HasSubstr(ball), testing::HasSubstr(faces),
                             testing::HasSubstr("vector(0, -2, 0), b")));
  EXPECT_THAT(*engine_test(named, "bullet"),
              testing::AllOf(testing::HasSubstr("convexSweepTest"),
                             testing::HasSubstr("corners[] = {0, 2, 1, 1, 2, 3};\n")));
  EXPECT_THAT(*engine_test(named, "physx"), testing::HasSubstr("eMESH_BOTH_SIDES"));
  EXPECT_THAT(
      *engine_test(named, "jolt"),
      testing::HasSubstr("\nsettings.mBackFaceModeTriangles = settings.mBackFaceModeConvex"));
  EXPECT_EQ(engine_test(named, "box3d").error().message(),
            "ball.json: box3d has no tests of meshes");
  query.patches[0].one_sided = true;
  EXPECT_THAT(*engine_test(named, "jolt"), testing::HasSubstr("\nsettings.mBackFaceModeConvex = "));
  EXPECT_THAT(*engine_test(named, "physx"), testing::Not(testing::HasSubstr("eMESH_BOTH_SIDES")));
  for (const std::string engine : {"rapier", "bullet"}) {
    EXPECT_EQ(engine_test(named, engine).error().message(),
              "ball.json: " + engine + " has no tests of one-sided meshes");
  }
}

/// How many lines a test has before the one that asks the engine, without comments.
long lines_before(const std::string& text, const std::string& call) {
  std::istringstream lines(text.substr(0, text.rfind('\n', text.find(call))));
  long count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.empty() || line.starts_with("//") ? 0 : 1;
  }
  return count;
}

/// A hull or a capsule needs a helper beside.
TEST(EngineTest, SetsUpABallAndABoxOrAMeshIn20LinesAtMost) {
  NamedCase named = falling_ball();
  const auto expect_short = [&](const std::string& engine, const std::string& call) {
    const std::string text = *engine_test(named, engine);
    ASSERT_THAT(text, testing::HasSubstr(call));
    EXPECT_LE(lines_before(text, call), 20) << engine;
  };
  for (const bool has_faces : {false, true}) {
    if (has_faces) named.value.query.patches[1].faces = {{0, 2, 1}, {1, 2, 3}};
    expect_short("rapier", "a.castShape(");
    expect_short("jolt", "target.CastShape(");
    expect_short("physx", "prototype.sweep(");
    if (!has_faces) expect_short("havok", "hk.HP_World_ShapeCastWithCollector(");
    if (has_faces) expect_short("bullet", "world.convexSweepTest(");
  }
}

TEST(EngineTest, TurnsBodiesAsTheEngineDoesOrRefusesThem) {
  NamedCase named = falling_ball();
  Query& query = named.value.query;
  query.t_max = 1;
  query.patches[1].positions.resize(4);
  named.value.truth.witness->weights[1].resize(4);
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

TEST(EngineTest, RoundsWhatIsLongToRead) {
  NamedCase named = falling_ball();
  named.value.truth.witness->t = Rational("100000000000000000001/100000000000000000000");
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::AllOf(testing::HasSubstr("// At t = about 1 of t_max = 2 the"),
                             testing::HasSubstr("// about (-4, 2, 0.5) and (-5, 1, -5),\n")));
}

TEST(EngineTest, NamesPointsWhereTheTestHasThem) {
  NamedCase named = falling_ball();
  for (MovingPatch<double>& patch : named.value.query.patches) patch.velocities[0][0] = 1;
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::HasSubstr("\n// (-4, 2, 1/2) and (-5, 1, -5)"))
      << "the second is at rest";
  EXPECT_THAT(*engine_test(named, "bullet"),
              testing::HasSubstr("\n// (-3, 2, 1/2) and (-4, 1, -5)"))
      << "both move";
  named.value.query.patches[1].faces = {{0, 2, 1}, {1, 2, 3}};
  EXPECT_THAT(*engine_test(named, "bullet"),
              testing::HasSubstr("\n// (-4, 2, 1/2) and (-5, 1, -5)"));
  std::swap(named.value.query.patches[0], named.value.query.patches[1]);
  std::swap(named.value.truth.witness->weights[0], named.value.truth.witness->weights[1]);
  EXPECT_THAT(*engine_test(named, "bullet"),
              testing::HasSubstr("\n// (-4, 2, 1/2) and (-5, 1, -5)"))
      << "the mesh is the second";
}

TEST(EngineTest, HasNoHelperThatNothingCalls) {
  for (const char* engine : {"rapier", "jolt", "physx", "havok"}) {
    const std::string text = *engine_test(falling_ball(), engine);
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("//:"))) << engine;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("hull"))) << engine;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("capsule"))) << engine;
  }
}

TEST(EngineTest, GivesEndsExactly) {
  NamedCase named = vertex_through_face();
  named.value.query.t_max = 0.75;
  const Result<std::string> text = engine_test(named, "tight-inclusion");
  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, testing::HasSubstr("t_max = 0.75;")) << "of a step of 1";
  EXPECT_THAT(*text, testing::HasSubstr("ticcd::vertexFaceCCD(\n      V(0.25, 0.25, 0.5), V(0,"));
  EXPECT_THAT(*text, testing::HasSubstr("      V(0.25, 0.25, -0.5), "));
  EXPECT_THAT(*text, testing::HasSubstr("EXPECT_LE(share, 0.5);"));
  named.value.query.patches[0].velocities[0][0] = 0x1p-80;
  EXPECT_FALSE(engine_test(named, "tight-inclusion")) << "an end is no double";
}

TEST(EngineTest, TakesASeparationWhereTheEngineDoes) {
  NamedCase named = vertex_through_face();
  named.value.query.separation = 0.25;
  const Result<std::string> text = engine_test(named, "ipc-toolkit");
  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, testing::HasSubstr("min_distance = 0.25,"));
  EXPECT_FALSE(engine_test(named, "fcl"));
}

TEST(EngineTest, RefusesAbsenceWhereTheEngineMayBeEarly) {
  NamedCase named = vertex_through_face();
  named.value.truth = {};
  named.value.truth.collides = false;
  named.value.truth.clearance = LinearClearance{Rational(1, 4), true};
  named.value.query.t_max = 0.25;
  EXPECT_TRUE(engine_test(named, "fcl"));
  EXPECT_FALSE(engine_test(named, "ipc-toolkit"));
}

TEST(EngineTest, KeepsToThePlaneWhereTheEngineDoes) {
  for (const char* engine : {"box2d", "planck", "rapier2d"}) {
    EXPECT_FALSE(engine_test(falling_ball(), engine)) << engine;
  }
  NamedCase flat = falling_ball();
  for (MovingPatch<double>& patch : flat.value.query.patches) {
    for (Vec3<double>& p : patch.positions) p[2] = 0;
  }
  const Result<std::string> text = engine_test(flat, "box2d");
  ASSERT_TRUE(text.has_value());
  EXPECT_THAT(*text, testing::HasSubstr("b2MakeProxy( (b2Vec2[]){ { -4, 3 } }, 1, 1 )"));
}

TEST(EngineTest, RefusesWhereNothingIsProven) {
  NamedCase named = falling_ball();
  named.value.query.t_max = 0.5;
  EXPECT_FALSE(engine_test(named, "rapier")) << "the contact comes later";
}

}  // namespace
}  // namespace ccdfuzz
