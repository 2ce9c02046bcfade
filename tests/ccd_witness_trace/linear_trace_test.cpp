#include <gtest/gtest.h>

#include "traced.hpp"

namespace ccdfuzz {
namespace {

Witness on_the_triangle(const Rational& t) {
  Witness witness = at_time(t);
  witness.uv[1] = {Rational(1, 4), Rational(1, 4)};
  return witness;
}

TEST(LinearTrace, IsOfTheAxesThatTheQueryIsDecidedBy) {
  const Trace trace =
      tracer_of("tdibm-c")->trace(falling_vertex(), on_the_triangle(Rational(1, 2)), {});
  EXPECT_FALSE(trace.lost);
  EXPECT_EQ(trace.pairs, 1U) << "nothing is split";
  EXPECT_EQ(trace.levels, 0);
  EXPECT_EQ(trace.false_claims, 0U);
  ASSERT_TRUE(trace.margin);
  EXPECT_EQ(trace.margin->by.below, 1);
  EXPECT_EQ(trace.margin->by.direction[0], 0);
  EXPECT_EQ(trace.margin->by.direction[1], 0);
  EXPECT_EQ(trace.margin->by.times.lo, 0);
  EXPECT_LT(trace.margin->by.times.hi, .5);
  EXPECT_GT(trace.margin->by.times.hi, .5 - 0x1p-40);
}

TEST(LinearTrace, LosesAWitnessThatIsNoContactToTheAxisThatExcludesIt) {
  const Trace trace =
      tracer_of("tdibm-c")->trace(falling_vertex(), on_the_triangle(Rational(1, 4)), {});
  ASSERT_TRUE(trace.lost);
  EXPECT_GE(trace.false_claims, 1U);
  EXPECT_GE(trace.loss->by.axis, 0);
  ASSERT_TRUE(trace.loss->left);
  EXPECT_GT(trace.loss->left->lo, .25);
}

TEST(LinearTrace, LeavesNothingOfAMiss) {
  Query query = falling_vertex();
  query.patches[0].positions[0][0] = -1;  // beside the triangle
  const Trace trace = tracer_of("tdibm-c")->trace(query, on_the_triangle(Rational(1, 2)), {});
  ASSERT_TRUE(trace.lost);
  EXPECT_FALSE(trace.loss->left);
}

TEST(LinearTrace, KeepsContactsOfEveryTimeScale) {
  for (const int exponent : {-1000, -60, 0, 60, 900}) {
    Query query = falling_vertex();
    query.t_max = std::ldexp(1.0, exponent);
    query.patches[0].velocities[0][2] = std::ldexp(-3.0, -exponent);  // at t_max/3
    const Rational t = exact(query.t_max) / 3;
    EXPECT_FALSE(tracer_of("tdibm-c")->trace(query, on_the_triangle(t), {}).lost) << exponent;
  }
}

}  // namespace
}  // namespace ccdfuzz
