#include "files/engine_test.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <sstream>

#include "case/mesh.hpp"
#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {
namespace {

/// A ball of radius 1 that falls onto a side of a box, which it touches at t = 1.
NamedCase falling_ball() {
  NamedCase named;
  named.id = "ball.json";
  Query& query = named.value.query;
  query.patches[0] = {Shape::hull(1), {{-5, 3, 0.5}}, {{0, -1, 0}}, {}, {}, 1};
  query.patches[1] = {
      Shape::hull(4), {{-5, -1, -5}, {-5, -1, 5}, {-5, 1, -5}, {-5, 1, 5}}, {{0, 0, 0}}};
  query.t_max = 1;
  named.value.truth.collides = true;
  named.value.truth.witness = Witness{Rational(1), {}};
  named.value.truth.witness->weights = {{{1}, {0, 0, Rational(9, 20), Rational(11, 20)}}};
  return named;
}

/// The centre of a ball of radius 1, at (distance, 0, 0), turns about 0. It touches a segment where
/// its x is down to `x`.
NamedCase turning_ball(const BodyTurn& turn, double distance, double x) {
  NamedCase named;
  Query& query = named.value.query;
  query.t_max = 1;
  query.patches[0] = {Shape::hull(1), {{distance, 0, 0}}, {{0, 0, 0}}, {}, {}, 1};
  query.patches[0].turn = turn;
  query.patches[1] = {Shape::hull(2), {{x - 1, 0, 0}, {x - 1, 32, 0}}, {{0, 0, 0}}};
  named.value.truth = decide(query).truth;
  return named;
}

/// The latest fraction that a test allows.
double latest_of(const std::string& text) {
  constexpr std::string_view kBefore = "fraction <= ";
  return std::strtod(text.c_str() + text.find(kBefore) + kBefore.size(), nullptr);
}

TEST(EngineTest, AllowsBodiesThatTurnToComeAsDeepAsTheToleranceIs) {
  const NamedCase by_angle = turning_ball({{1, 0}, {0.6, 0.8}}, 5, 4),
                  by_quaternion = turning_ball({{1, 0, 0, 0}, {0.6, 0, 0, 0.8}}, 25, 7);
  EXPECT_NEAR(latest_of(*engine_test(by_angle, "box2d")), 0.68396822, 1e-7)
      << "15/22, and until x is 4 - 0.00625";
  EXPECT_NEAR(latest_of(*engine_test(by_quaternion, "box3d")), 0.68195269, 1e-7)
      << "15/22, and until x is 7 - 0.00625";
}

TEST(EngineTest, AllowsAFindOfTheEngineWhatItsJudgeAllowed) {
  NamedCase named = falling_ball();
  named.value.query.t_max = 2;
  named.value.expect = {{"plugin:rapier", Outcome::kLate}, {"plugin:fcl-bodies", Outcome::kLate}};
  named.value.origin.more = {{"depth_tolerance", "0.25"}, {"time_tolerance", "0.125"}};
  EXPECT_THAT(*engine_test(named, "rapier"), testing::HasSubstr("share <= 0.625,"));
  EXPECT_THAT(*engine_test(named, "jolt"), testing::HasSubstr("share <= 0.50005,"));
  named.value.origin.more.erase("depth_tolerance");
  EXPECT_THAT(*engine_test(named, "fcl-bodies"), testing::HasSubstr("EXPECT_LE(share, 0.5625);"));
}

/// How many lines a test has before the one that asks the engine, without comments. A name says in
/// its template how that begins; nothing if the test has no such line.
std::optional<long> lines_before_call(const std::string& text, std::string_view of) {
  constexpr std::string_view kName = "\n//= call: ";
  const size_t begin = of.find(kName) + kName.size();
  const size_t at = text.find(of.substr(begin, of.find('\n', begin) - begin));
  if (at == text.npos) return std::nullopt;
  std::istringstream lines(text.substr(0, text.rfind('\n', at)));
  long count = 0;
  for (std::string line; std::getline(lines, line);) {
    count += line.empty() || line.starts_with("//") ? 0 : 1;
  }
  return count;
}

/// A body that falls.
MovingPatch<double> body_of(const Points<double>& points, double radius) {
  return {Shape::hull(static_cast<int>(points.size())), points, {{0, -1, 0}}, {}, {}, radius};
}

/// Bodies of all kinds that a form of a test has words for: points, capsules, boxes, hulls,
/// meshes.
std::vector<MovingPatch<double>> all_bodies() {
  std::vector<MovingPatch<double>> bodies;
  const Points<double> tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                       quadrangle = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  Points<double> box = quadrangle;
  box[2][0] = 1;
  for (size_t i = 0; i < 4; ++i) box.push_back(box[i] + Vec3<double>(0, 0, 1));
  for (const double radius : {0.0, 1.0}) {
    for (const size_t count : {1U, 2U, 3U, 4U}) {
      bodies.push_back(body_of({tetrahedron.begin(), tetrahedron.begin() + count}, radius));
    }
    bodies.push_back(body_of(quadrangle, radius));
    bodies.push_back(body_of(box, radius));
  }
  for (const bool one_sided : {false, true}) {
    bodies.push_back(body_of(tetrahedron, 0));
    bodies.back().faces = {{0, 2, 1}, {1, 2, 3}};
    bodies.back().one_sided = one_sided;
  }
  return bodies;
}

/// What a case asks of an engine, with a contact at the first point of both.
NamedCase of_bodies(const MovingPatch<double>& a, const MovingPatch<double>& b) {
  NamedCase named = falling_ball();
  Truth& truth = named.value.truth;
  named.value.query.patches = {a, b};
  for (size_t side = 0; side < 2; ++side) {
    const size_t count = named.value.query.patches[side].positions.size();
    truth.witness->weights[side] = std::vector<Rational>(count, Rational(0));
    truth.witness->weights[side][0] = Rational(1);
  }
  return named;
}

TEST(EngineTest, SetsUpWhateverItAsksIn20LinesAtMost) {
  const std::vector<std::optional<BodyTurn>> turns = {
      std::nullopt, BodyTurn{{}, {}, {1, 0, 0}, {0, 0, 0.25}},
      BodyTurn{{1, 0, 0, 0}, {0.6, 0, 0, 0.8}}, BodyTurn{{1, 0}, {0.6, 0.8}}};
  std::vector<NamedCase> cases = {falling_ball(), falling_ball()};
  for (NamedCase& named : cases) named.value.truth.witness->weights = {};
  cases[0].value.query.patches = {
      MovingPatch<double>{Shape::point(), {{0.25, 0.25, 0.5}}, {{0, 0, -1}}},
      MovingPatch<double>{
          Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Points<double>(3, {0, 0, 0})}};
  cases[1].value.query.patches = {
      MovingPatch<double>{Shape::curve(1), {{0, 0, 1}, {1, 0, 1}}, {{0, 0, -1}, {0, 0, -1}}},
      MovingPatch<double>{Shape::curve(1), {{0, -1, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 0}}}};
  for (const std::optional<BodyTurn>& turn : turns) {
    for (MovingPatch<double> a : all_bodies()) {
      for (MovingPatch<double> b : all_bodies()) {
        if (!a.faces.empty() && !b.faces.empty()) continue;
        a.turn = b.turn = turn;
        cases.push_back(of_bodies(a, b));
      }
    }
  }
  for (const EngineTemplate& of : engine_templates()) {
    int count = 0;
    for (const NamedCase& named : cases) {
      const auto text = engine_test(named, of.engine);
      if (!text) continue;
      ++count;
      const bool is_of_mesh = has_mesh(named.value.query) && !of.mesh_text.empty();
      const auto lines = lines_before_call(*text, is_of_mesh ? of.mesh_text : of.text);
      ASSERT_TRUE(lines) << of.engine << " has no call\n" << *text;
      // PhysX takes the corners of both one by one, and cooks both.
      const bool cooks_two = of.engine == "physx" &&
                             text->find("PxTriangleMeshDesc") != text->npos &&
                             text->find("PxConvexMeshDesc") != text->npos;
      EXPECT_LE(*lines, cooks_two ? 24 : 20) << *text;
    }
    EXPECT_GE(count, 2) << of.engine;
  }
}

TEST(EngineTest, SaysWhatIsPromisedAndTheVersionIfACommentCanHoldIt) {
  NamedCase named = falling_ball();
  named.value.origin.more = {{"version", "\"0.21.0\""}, {"depth", "0.00031"}};
  EXPECT_THAT(*engine_test(named, "rapier"), testing::Not(testing::HasSubstr("version")))
      << "of whatever it was found";
  named.value.expect["plugin:rapier"] = Outcome::kLate;
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::StartsWith("// Promised: casting a shape gives the first time of impact: "));
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::HasSubstr("version \"0.21.0\", 0.00031 deep, 3.1 times the tolerance.\n"));
  named.value.origin.more["version"] =
      "\"1\u2028process.exit(0)\"";  // to JavaScript this is a line's end
  EXPECT_THAT(*engine_test(named, "rapier"), testing::Not(testing::HasSubstr("exit")));
}

TEST(EngineTest, SaysWhereAndWhenFeaturesTouchOrThatTheyDoNot) {
  NamedCase named;
  Query& query = named.value.query;
  query.patches[0] = {Shape::point(), {{0.25, 0.25, 0.25}}, {}};
  query.patches[0].ends = {{0.25, 0.25, -0.75}};
  query.patches[1] = {
      Shape::triangle(1), {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, Points<double>(3, {0, 0, 0})};
  query.t_max = 0.5;
  named.value.truth.witness = Witness{Rational(1, 4), {}};
  named.value.truth.witness->uv[1] = {Rational(1, 4), Rational(1, 4)};
  EXPECT_THAT(*engine_test(named, "fcl"), testing::HasSubstr("At 1/2 of the way"));
  EXPECT_THAT(*engine_test(named, "fcl"), testing::HasSubstr("EXPECT_LE(share, 0.50000"));
  query.t_max = 0;
  named.value.truth.clearance = LinearClearance{0, true};
  EXPECT_THAT(*engine_test(named, "fcl"), testing::StartsWith("// Promised: CCD"));
  EXPECT_THAT(*engine_test(named, "fcl"), testing::HasSubstr("\n// Nothing touches on the way."));
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
              testing::AllOf(testing::HasSubstr("points_b) p -= btVector3(1, 0, 0);"),
                             testing::HasSubstr("btQuaternion(0, 0, 0.1246747333852")));
  EXPECT_THAT(
      *engine_test(named, "fcl-bodies"),
      testing::AllOf(testing::HasSubstr("turn_b(Eigen::AngleAxisd(0.25, V(0, 0, 0.25)."),
                     testing::HasSubstr("V(1, 0, 0) - turn_b * (V(1, 0, 0) - V(0, 0, 0)), V(1, 0,"),
                     testing::HasSubstr("way_a(I, V(-5, 3, 0.5), I, V(-5, 2, 0.5), V(0, 0, 0))")));
  EXPECT_TRUE(refused("rapier") && refused("box3d"));
  query.patches[1].turn = BodyTurn{{1, 0, 0, 0}, {0.6, 0, 0, 0.8}};
  EXPECT_THAT(*engine_test(named, "box3d"),
              testing::AllOf(testing::HasSubstr(".q2 = { { 0, 0, 0.8 }, 0.6 }"),
                             testing::Not(testing::HasSubstr("Promised"))));
  EXPECT_TRUE(refused("bullet"));
  query.patches[1].turn->to = {1, 0, 0, 1};
  EXPECT_TRUE(refused("box3d")) << "it needs quaternions of unit length";
  query.patches[1].turn = BodyTurn{{1, 0}, {0.6, 0.8}};
  EXPECT_TRUE(refused("box3d"));
  for (MovingPatch<double>& patch : query.patches)
    for (Vec3<double>& p : patch.positions) p[2] = 0;
  EXPECT_THAT(*engine_test(named, "box2d"), testing::HasSubstr(".q2 = { 0.6, 0.8 }"));
  query.patches[1].turn = BodyTurn{{}, {}, {1, 0, 0}, {0, 0, -0.25}};
  EXPECT_THAT(*engine_test(named, "planck"),
              testing::HasSubstr("vector(1, 0, 0), vector(1, 0, 0), -0.25);"));
  EXPECT_TRUE(refused("box2d"));
}

TEST(EngineTest, TurnsACapsuleFromTheAxisOfTheEngine) {
  NamedCase named = falling_ball();
  MovingPatch<double>& capsule = named.value.query.patches[0];
  capsule.shape = Shape::hull(2);
  capsule.positions = {{-4, 6, 0.5}, {-4, 9, 4.5}};
  named.value.truth.witness->weights[0].emplace_back(0);
  EXPECT_THAT(*engine_test(named, "rapier"),
              testing::AllOf(testing::HasSubstr("new RAPIER.Capsule(2.5, 1);"),
                             testing::HasSubstr("{ x: 0.4472136, y: 0, z: -0, w: 0.8944272 }")))
      << "from y to (0, 3/5, 4/5)";
  EXPECT_THAT(*engine_test(named, "jolt"), testing::HasSubstr("Quat(0.4472136, 0, -0, 0.8944272)"));
  EXPECT_THAT(*engine_test(named, "physx"),
              testing::HasSubstr("PxQuat(0, -0.56568545, 0.42426407, 0.70710677)"))
      << "from x";
  capsule.positions[1][1] = 9 + 0x1p-22;
  EXPECT_FALSE(engine_test(named, "jolt")) << "its middle is no float";
}

}  // namespace
}  // namespace ccdfuzz
