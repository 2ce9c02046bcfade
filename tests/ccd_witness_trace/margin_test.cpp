#include <gtest/gtest.h>

#include "traced.hpp"

namespace ccdfuzz {
namespace {

Trace traced(const std::string& spec, const Query& query, const Witness& witness,
             const TraceOptions& options = {}) {
  return tracer_of(spec)->trace(query, witness, options);
}

TEST(Margin, IsZeroWhereTheExclusionEndsInTheWitness) {
  const Trace trace = traced("tdibm", meeting_points(1), at_time(Rational(1, 2)));
  ASSERT_FALSE(trace.lost);
  ASSERT_TRUE(trace.margin);
  EXPECT_EQ(trace.margin->ulps, 0U);
  EXPECT_EQ(trace.margin->place.level, 0);
  EXPECT_EQ(trace.margin->by.axis, 0);
  EXPECT_EQ(trace.margin->by.direction, Vec3<double>(1, 0, 0));
  EXPECT_EQ(trace.false_claims, 0U);
}

// Pulled apart by F each, the points separate on x until t = 1/2 − F and from 1/2 + F on. Below 1/2
// a step is 2^-54, above it 2^-53.
TEST(Margin, CountsTheDoublesToTheNearestExcludedTime) {
  const Trace trace = traced("tdibm-h:0x1p-40@absolute@unit-axes@exact-windows", meeting_points(1),
                             at_time(Rational(1, 2)));
  ASSERT_FALSE(trace.lost);
  ASSERT_TRUE(trace.margin);
  EXPECT_EQ(trace.margin->ulps, std::uint64_t{1} << 13) << "the later one is nearer in steps";
  EXPECT_EQ(trace.margin->by.below, 1) << "after the meeting patch 2 is the lower one";
  EXPECT_EQ(trace.margin->by.times.lo, .5 + 0x1p-40);
  const Trace before = traced("tdibm-h:0x1p-40@absolute@unit-axes@exact-windows",
                              meeting_points(.5), at_time(Rational(1, 2)));
  EXPECT_EQ(before.margin->ulps, std::uint64_t{1} << 14);
  EXPECT_EQ(before.margin->by.below, 0);
  EXPECT_EQ(before.margin->by.times.hi, .5 - 0x1p-40);
}

// They meet at t = 1/3, between two doubles; the root is rounded to one of them.
TEST(Margin, IsZeroBetweenTheWitnessAndTheNextDouble) {
  Query query = meeting_points(1);
  query.patches[1].velocities[0] = {-2, 0, 0};
  const Rational third(1, 3);
  const Trace trace = traced("tdibm", query, at_time(third));
  ASSERT_TRUE(trace.margin);
  EXPECT_EQ(trace.margin->ulps, 0U);
  // fl(1/3) is below 1/3: what is excluded after it takes the witness, what before it does not.
  ASSERT_LT(exact(1. / 3), third);
  EXPECT_TRUE(trace.lost);
  EXPECT_EQ(trace.loss->by.times.lo, 1. / 3);
  EXPECT_EQ(trace.loss->left->hi, 1. / 3);
  EXPECT_EQ(trace.loss->place.level, 0);
  EXPECT_FALSE(traced("tdibm-e", query, at_time(third)).lost);
  EXPECT_FALSE(traced("tdibm-rational", query, at_time(third)).lost);
  EXPECT_FALSE(traced("tdibm-c", query, at_time(third)).lost);
}

TEST(Margin, IsNothingWhereNothingIsExcluded) {
  Query query = meeting_points(1);
  query.patches[1] = query.patches[0];
  for (const std::string& spec : every_method_but()) {
    const Trace trace = traced(spec, query, at_time(Rational(1, 2)));
    EXPECT_FALSE(trace.lost) << spec;
    EXPECT_FALSE(trace.margin) << spec;
  }
}

// Where both points are at the same place, computed gaps are 0: all that keeps the witness is E.
TEST(Slack, IsOneErrorBoundWhereTheCertifiedGapIsZero) {
  const Trace trace = traced("tdibm-c", meeting_points(.5), at_time(Rational(1, 2)));
  ASSERT_TRUE(trace.slack);
  EXPECT_EQ(trace.slack->value, 1);
  EXPECT_EQ(trace.slack->gap.window.hi, .5) << "in the query's time";
  EXPECT_FALSE(traced("tdibm-e", meeting_points(.5), at_time(Rational(1, 2))).slack);
}

TEST(Slack, IsTheOverlapInUlpsForTheTraditionalMethod) {
  Query query;  // two points at rest, one ulp apart
  query.patches[0] = {Shape::point(), {{1, 0, 0}}, {{0, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1 + 0x1p-52, 0, 0}}, {{0, 0, 0}}};
  query.t_max = 1;
  const Trace lost = traced("trad:aabb", query, at_time(Rational(1, 2)));
  EXPECT_TRUE(lost.lost);
  EXPECT_EQ(lost.loss->by.axis, 0);
  EXPECT_EQ(lost.loss->by.below, 0);
  ASSERT_TRUE(lost.slack);
  EXPECT_EQ(lost.slack->value, -1);
}

}  // namespace
}  // namespace ccdfuzz
