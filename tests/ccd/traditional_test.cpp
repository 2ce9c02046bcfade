#include "ccd/traditional.hpp"

#include <gtest/gtest.h>

#include "generators/draw_contact.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

SearchOptions coarse() {
  SearchOptions options;
  options.precision = 1e-2;
  options.max_pops = 20'000;
  return options;
}

TEST(Traditional, FindsDrawnContactsInTime) {
  Traditional oriented, aligned(BoxKind::kAxisAligned);
  constexpr std::uint64_t kDraws = kOneIn == 1 ? 50 : 10;
  std::uint64_t hits = 0;
  for (std::uint64_t index = 0; index < kDraws; ++index) {
    Draw random{Random::keyed({index})};
    const Case known = draw_contact(random, {0, 0}).value();
    for (Traditional* method : {&oriented, &aligned}) {
      const Answer answer = method->answer(known.query, coarse());
      ASSERT_NE(answer.verdict, Verdict::kMiss) << index;
      EXPECT_LE(exact(answer.toi.value()), known.truth.witness->t) << index;
      hits += answer.verdict == Verdict::kHit;
    }
  }
  EXPECT_GT(hits, kDraws * 8 / 5) << "of " << 2 * kDraws;
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
