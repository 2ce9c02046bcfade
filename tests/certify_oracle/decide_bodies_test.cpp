#include "certify/oracle/decide_bodies.hpp"

#include <gtest/gtest.h>

#include "ball_into_valley.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/nearest_points.hpp"
#include "generators/bodies.hpp"
#include "generators/draw/draw.hpp"

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

TEST(DecideBodies, AFirstContactOfRationalLengthsIsExact) {
  const Query query = {{body(box(5, 1, 5), {0, 0, 0}), body({{-4, 3, 0.5}}, {0, -1, 0}, 1)}, 4};
  const Truth truth = decide(query).truth;
  EXPECT_EQ(truth.collides, true);
  EXPECT_EQ(truth.witness->t, Rational(1));
  EXPECT_EQ(truth.clear_until, Rational(1));
}

TEST(DecideBodies, ABallAndACornerThatMeetAtAnIrrationalTimeAreEnclosed) {
  const Query query = {{body(box(1, 1, 1), {0, 0, 0}), body({{4, 3.5, 3.25}}, {-1, -1, -1}, 0.7)},
                       8};
  const Truth truth = decide(query).truth;
  EXPECT_EQ(truth.collides, true);
  EXPECT_GT(truth.witness->t, *truth.clear_until);
  EXPECT_LE(bracket_of(truth), 0x1p-40);
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

TEST(DecideBodies, AreDecidedWhateverTheyAre) {
  Draw draw = Draw::mostly_small(Random(1));
  std::array<int, 2> count{};
  for (int i = 0; i < 300; ++i) {
    Query query;
    const int bits = draw.coin() ? 4 : 50;
    for (MovingPatch<double>& patch : query.patches) {
      Points<double> points(draw.below(9) + 1);
      const auto real = [&] {
        return std::ldexp(static_cast<double>(draw.integer(-(1L << bits), 1L << bits)), 4 - bits);
      };
      for (Vec3<double>& p : points) {
        for (int k = 0; k < 3; ++k) p[k] = real();
      }
      Vec3<double> velocity;
      for (int k = 0; k < 3; ++k) velocity[k] = 4 * real();
      patch = body(points, velocity, draw.coin() ? std::abs(real()) / 8 : 0);
    }
    const Truth truth = decide(query).truth;
    ASSERT_TRUE(truth.collides) << i;
    ++count[*truth.collides ? 1 : 0];
    if (*truth.collides && truth.witness->t > 0) {
      EXPECT_LE(bracket_of(truth), 0x1p-40) << i;
    }
  }
  EXPECT_GT(count[0], 30);
  EXPECT_GT(count[1], 30);
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

TEST(DecideMesh, TheFirstFaceThatIsThereIsFound) {
  Query query = ball_into_valley();
  auto& [mesh, ball] = query.patches;
  std::swap(mesh.faces[0], mesh.faces[1]);
  for (const bool is_one_sided : {false, true}) {
    mesh.one_sided = is_one_sided;
    const Truth truth = decide(query).truth;
    ASSERT_EQ(truth.collides, true);
    EXPECT_EQ(truth.witness->t, 1);
    EXPECT_EQ(truth.clear_until, Rational(1));
    EXPECT_EQ(truth.witness->weights[0],
              (std::vector<Rational>{Rational(7, 40), Rational(7, 40), Rational(13, 20), 0}));
    EXPECT_TRUE(check_case({query, truth, {}, {}, {}}));
  }
  // Through the first from behind, the other comes later.
  std::swap(mesh.faces[1][1], mesh.faces[1][2]);
  ball.velocities[0] = {-1, -1, 0};
  const Truth truth = decide(query).truth;
  ASSERT_EQ(truth.collides, true);
  EXPECT_EQ(truth.witness->weights[0][2], 0);
  EXPECT_GT(truth.witness->t, 1);
  EXPECT_TRUE(check_case({query, truth, {}, {}, {}}));
  // From behind both there is nothing.
  std::swap(mesh.faces[0][1], mesh.faces[0][2]);
  const Truth none = decide(query).truth;
  EXPECT_EQ(none.collides, false);
  EXPECT_TRUE(check_case({query, none, {}, {}, {}}));
}

}  // namespace
}  // namespace ccdfuzz
