#include "ccd/search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ccd/tdibm.hpp"
#include "ccd/traditional.hpp"
#include "meeting_points.hpp"
#include "random_query.hpp"

namespace ccdfuzz {
namespace {

TEST(Search, DepthIsTheLeastThatMeetsThePrecision) {
  for (const double precision : {1., .5, .3, .25, 1e-2, 1e-4, 0x1p-20, 1e-6}) {
    const int depth = depth_for(precision);
    EXPECT_LE(std::ldexp(1.0, -depth), precision);
    EXPECT_GT(std::ldexp(1.0, 1 - depth), precision);
  }
  EXPECT_EQ(depth_for(1e-300), Cell::kMaxDepth);
}

TEST(Search, MemoryBudgetGivesUndecided) {
  Tdibm<ErrorBoundIntended> method;
  SearchOptions options;
  options.max_bytes = 1000;
  const Answer answer = method.answer(twice_the_same(Shape::triangle(2)), options);
  EXPECT_EQ(answer.verdict, Verdict::kUndecided);
  EXPECT_GT(answer.bytes, options.max_bytes) << "what ended it";
  EXPECT_EQ(answer.toi, 0);
}

template <class Method>
void expect_no_miss(Method&& method, const Query& query) {
  SearchOptions options;
  options.max_pops = 2000;
  const Answer answer = method.answer(query, options);
  EXPECT_NE(answer.verdict, Verdict::kMiss);
  EXPECT_EQ(answer.toi, 0);
}

TEST(Search, IdenticalStaticPatchesAreNeverMissed) {
  expect_no_miss(Tdibm<Plain>(), twice_the_same(Shape::triangle(2)));
  expect_no_miss(Tdibm<PullApart>(PullApart(1e-12)), twice_the_same(Shape::triangle(2)));
  expect_no_miss(Tdibm<ErrorBoundIntended>(), twice_the_same(Shape::triangle(2)));
  expect_no_miss(Tdibm<ErrorBoundPrinted>(), twice_the_same(Shape::triangle(2)));
  expect_no_miss(Traditional(), twice_the_same(Shape::triangle(2)));
  expect_no_miss(Traditional(BoxKind::kAxisAligned), twice_the_same(Shape::triangle(2)));
}

TEST(Search, PatchesWithoutAnyAxisAreNeverMissed) {
  Query query = twice_the_same(Shape::triangle(2));
  for (MovingPatch<double>& patch : query.patches) {
    patch.positions.assign(6, patch.positions[0]);
  }
  expect_no_miss(Tdibm<Plain>(), query);
  expect_no_miss(Tdibm<ErrorBoundIntended>(), query);
  expect_no_miss(Traditional(), query);
}

TEST(Search, TheStepIsClosedAtItsEnd) {
  Tdibm<Plain> plain;
  Tdibm<ErrorBoundIntended> error_bound;
  for (const double t_max : {.5, std::nextafter(.5, 1.), 1.}) {
    EXPECT_EQ(plain.answer(meeting_points(t_max), {}).verdict, Verdict::kHit) << t_max;
    EXPECT_EQ(plain.answer(meeting_points(t_max), {}).toi, .5) << t_max;
    EXPECT_EQ(error_bound.answer(meeting_points(t_max), {}).verdict, Verdict::kHit) << t_max;
  }
  EXPECT_EQ(plain.answer(meeting_points(std::nextafter(.5, 0.)), {}).verdict, Verdict::kMiss);
}

TEST(Search, TheStepIsClosedAtItsStart) {
  Query query;  // touching at t = 0, parting after
  query.patches[0] = {Shape::point(), {{1, 2, 3}}, {{1, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1, 2, 3}}, {{-1, 0, 0}}};
  for (const double t_max : {0., 1.}) {
    query.t_max = t_max;
    EXPECT_EQ(Tdibm<Plain>().answer(query, {}).toi, 0) << t_max;
    EXPECT_EQ(Tdibm<ErrorBoundIntended>().answer(query, {}).toi, 0) << t_max;
    EXPECT_EQ(Traditional().answer(query, {}).toi, 0) << t_max;
  }
}

}  // namespace
}  // namespace ccdfuzz
