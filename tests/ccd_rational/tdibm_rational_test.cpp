#include "ccd/rational/tdibm_rational.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ccd/rational/gap.hpp"
#include "ccd/rational/proves_clear.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {
namespace {

/// A point moving from p with velocity v.
MovingPatch<double> moving_point(const Vec3<double>& p, const Vec3<double>& v) {
  return {Shape::point(), {p}, {v}};
}

/// The flat triangle (degree 1) with corners (0,0,z), (1,0,z), (0,1,z), moving with velocity v.
MovingPatch<double> flat_triangle(double z, const Vec3<double>& v) {
  return {Shape::triangle(1), {{0, 0, z}, {0, 1, z}, {1, 0, z}}, {v, v, v}};
}

/// Every length of the query times 2^k. Requires that nothing rounds.
Query scaled(Query query, int k) {
  for (MovingPatch<double>& patch : query.patches) {
    for_each_coordinate(patch, [&](double& x) { x = std::ldexp(x, k); });
  }
  return query;
}

Answer ask(const Query& query) {
  return TdibmRational().answer(query, {});
}

TEST(TdibmRational, IsTheSameAtEveryScale) {
  const Query query{{moving_point({0.25, 0.25, 1}, {0, 0, -1}), flat_triangle(0, {0, 0, 0})}, 1};
  for (const int k : {-1072, -1022, -540, -85, 85, 540, 1000, 1023}) {
    const Answer answer = ask(scaled(query, k));
    ASSERT_EQ(answer.verdict, Verdict::kHit) << "2^" << k;
    EXPECT_EQ(*answer.toi, 1.0) << "2^" << k;
    Query before = scaled(query, k);
    before.t_max = 1 - 0x1p-20;
    EXPECT_EQ(ask(before).verdict, Verdict::kMiss) << "2^" << k;
  }
}

TEST(ProvesClear, CoversATimeThatIsNotADouble) {
  const Query query{{moving_point({0.25, 0.25, 1}, {0, 0, -3}), flat_triangle(0, {0, 0, 0})}, 1};
  const Rational contact(1, 3);
  EXPECT_FALSE(proves_clear(query, contact));
  EXPECT_TRUE(proves_clear(query, Rational(contact - power_of_two(-50))));
  const Query apart{{moving_point({0, 0, 1}, {0, 0, 0}), flat_triangle(0, {0, 0, 0})}, 1};
  EXPECT_FALSE(proves_clear(apart, power_of_two(1024))) << "beyond doubles";
}

/// A point that comes down on the corner of a flat patch at t = 1.
Query touching(const Shape& shape, double unit) {
  MovingPatch<double> flat{shape, {}, {}};
  for_each_control(shape, [&](int i, int j) { flat.positions.push_back({i * unit, j * unit, 0}); });
  flat.velocities.assign(flat.positions.size(), {0, 0, 0});
  return {{moving_point({0, 0, 1}, {0, 0, -1}), flat}, 1};
}

TEST(TdibmRational, WorkGrowsWithTheLengthOfItsIntegersAndIsBounded) {
  SearchOptions options;
  TdibmRational method;
  const auto work_at = [&](double unit) {
    return method.answer(touching(Shape::triangle(2), unit), options).work;
  };
  const std::uint64_t near = work_at(1), far = work_at(0x1p-300), most = work_at(0x1p-900);
  EXPECT_GT(near, 0U);
  EXPECT_GT(far, near);
  EXPECT_GT(most, far);
  options.max_work = most;
  EXPECT_EQ(method.answer(touching(Shape::triangle(2), 0x1p-900), options).verdict, Verdict::kHit);
  options.max_work = most / 2;
  const Answer ended = method.answer(touching(Shape::triangle(2), 0x1p-900), options);
  EXPECT_EQ(ended.verdict, Verdict::kUndecided);
  EXPECT_EQ(ended.note, "work budget exhausted");
  EXPECT_TRUE(ended.toi && *ended.toi <= 1);
  EXPECT_GT(ended.work, options.max_work);
  EXPECT_LT(ended.work, most);
}

TEST(TdibmRational, DecidesExponentsFromOneEndOfTheRangeToTheOther) {
  // A gap of the least double, or none, under a triangle of size 2^1000.
  for (const double height : {0.0, 0x1p-1074, -0x1p-1074}) {
    Query query = {{moving_point({0x1p998, 0x1p998, height}, {0, 0, 0}), {}}, 1};
    query.patches[1] = {Shape::triangle(1),
                        {{0, 0, 0}, {0, 0x1p1000, 0}, {0x1p1000, 0, 0}},
                        Points<double>(3, {0, 0, 0})};
    EXPECT_EQ(ask(query).verdict, height == 0 ? Verdict::kHit : Verdict::kMiss) << to_hex(height);
  }
}

// What has no bits at all, like the velocities of patches at rest, must not enter (a fuzzer saw an
// overflow here).
TEST(Units, AreOfThePositionsAloneWhereNothingMovesAndOfVelocitiesWhereAllBeginsAtTheOrigin) {
  Query query;
  query.t_max = 4;
  for (MovingPatch<double>& patch : query.patches) {
    patch = {Shape::curve(1), {{0.25, 0, 3}, {0, -7, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  }
  const exact_ccd::Units rest = exact_ccd::Units::of(query);
  EXPECT_EQ(rest.length, -2);
  EXPECT_EQ(rest.top, 3);  // |p| < 2^3
  for (MovingPatch<double>& patch : query.patches) std::swap(patch.positions, patch.velocities);
  const exact_ccd::Units from_origin = exact_ccd::Units::of(query);
  EXPECT_EQ(from_origin.length, -2 + from_origin.time);
  EXPECT_EQ(from_origin.top, 3 + from_origin.horizon);
}

}  // namespace
}  // namespace ccdfuzz
