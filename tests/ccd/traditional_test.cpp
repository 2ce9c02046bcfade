#include "ccd/traditional.hpp"

#include <gtest/gtest.h>

#include "planted.hpp"

namespace ccdfuzz {
namespace {

SearchOptions coarse() {
  SearchOptions options;
  options.precision = 1e-2;
  options.max_pops = 20'000;
  return options;
}

TEST(Traditional, FindsPlantedContactsOfAllShapesInTime) {
  Traditional oriented, aligned(BoxKind::kAxisAligned);
  int hits = 0;
  for (const Shape& a : kSomeShapes) {
    for (const Shape& b : kSomeShapes) {
      Draw random{Random::keyed({4, static_cast<std::uint64_t>(a.control_count()),
                                 static_cast<std::uint64_t>(b.control_count())})};
      const Planted planted = plant_contact(random, a, b);
      for (Traditional* method : {&oriented, &aligned}) {
        const Answer answer = method->answer(planted.query, coarse());
        const std::string what = to_text(a) + " " + to_text(b);
        ASSERT_NE(answer.verdict, Verdict::kMiss) << what;
        EXPECT_LE(exact(answer.toi.value()), planted.witness.t) << what;
        hits += answer.verdict == Verdict::kHit;
      }
    }
  }
  EXPECT_GT(hits, 80) << "of 98";
}

/// toi is the start of a window that is as narrow in time as the cells are in their parameters.
TEST(Traditional, SubdividesTimeAsTheParameters) {
  Query query;  // two points that meet at t = 1/3
  query.patches[0] = {Shape::point(), {{0, 0, 0}}, {{3, 0, 0}}};
  query.patches[1] = {Shape::point(), {{1, 0, 0}}, {{0, 0, 0}}};
  SearchOptions options;
  options.precision = 1e-4;
  const Answer answer = Traditional().answer(query, options);
  ASSERT_EQ(answer.verdict, Verdict::kHit);
  EXPECT_LE(*answer.toi, 1. / 3);
  EXPECT_GE(*answer.toi, 1. / 3 - 1e-4);
}

}  // namespace
}  // namespace ccdfuzz
