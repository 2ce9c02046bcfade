#include "report/loss.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace ccdfuzz {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two segments on the x axis, [t − 1, t] and [1 − t, 3 − t]: their ends meet at t = 1/2.
struct Meeting {
  Query query;
  Witness witness;
  Trace::Loss loss;

  Meeting() {
    query.patches[0] = {Shape::curve(1), {{-1, 0, 0}, {0, 0, 0}}, {{1, 0, 0}, {1, 0, 0}}};
    query.patches[1] = {Shape::curve(1), {{1, 0, 0}, {3, 0, 0}}, {{-1, 0, 0}, {-1, 0, 0}}};
    query.t_max = 1;
    witness.t = Rational(1, 2);
    witness.uv = {Uv<Rational>{1, 0}, Uv<Rational>{0, 0}};
    loss.place.window = {0, 1};
    loss.by.axis = 3;
    loss.by.direction = {2, 0, 0};
    loss.by.below = 0;
    loss.by.times = {0, .5, true, false};
  }
};

TEST(LossFacts, TouchingPartsOverlapByNothing) {
  const Meeting m;
  const LossFacts facts = facts_of(m.query, m.witness, m.loss);
  ASSERT_TRUE(facts.overlap);
  EXPECT_EQ(facts.overlap->length, 0);
  // The largest height at t* is that of the far end of patch 2, 2.5 along the unit axis.
  EXPECT_EQ(facts.overlap->height_ulp, 0x1p-51);
  EXPECT_EQ(facts.ulps_past, 0U);
}

TEST(LossFacts, OverlapIsALengthWhateverTheLengthOfTheAxis) {
  Meeting m;
  m.query.patches[0].positions[1][0] = .125;  // not a contact any more at its end: overlaps
  for (const double length : {1., 3., 0x1p-700, 0x1p700}) {
    m.loss.by.direction = {length, 0, 0};
    const LossFacts facts = facts_of(m.query, m.witness, m.loss);
    ASSERT_TRUE(facts.overlap);
    EXPECT_EQ(facts.overlap->length, .125) << length;
  }
}

TEST(LossFacts, MeasureOnlyThePartsThatWereSeparated) {
  Meeting m;
  // The lower half of patch 2 is the same; the lower half of patch 1 ends at −1/2 + t.
  m.loss.place.cells[0] = Cell{0, 0, 1, false};
  m.loss.place.cells[1] = Cell{0, 0, 1, false};
  EXPECT_EQ(facts_of(m.query, m.witness, m.loss).overlap->length, -.5);
}

TEST(LossFacts, CountsTheDoublesPastTheContact) {
  Meeting m;
  m.loss.by.times.hi = .5 + 3 * 0x1p-53;
  EXPECT_EQ(facts_of(m.query, m.witness, m.loss).ulps_past, 3U);
  m.loss.by.times = {.5 - 0x1p-54, 1, false, true};
  EXPECT_EQ(facts_of(m.query, m.witness, m.loss).ulps_past, 1U);
  m.loss.by.times = {.5 - 0x1p-54, .5 + 3 * 0x1p-53, false, false};
  EXPECT_EQ(facts_of(m.query, m.witness, m.loss).ulps_past, 1U) << "the nearer end";
  m.loss.by.times = {0, 1, true, true};
  EXPECT_EQ(facts_of(m.query, m.witness, m.loss).ulps_past, std::nullopt);
}

TEST(LossFacts, AnAxisOutOfRangeHasNoOverlap) {
  Meeting m;
  m.loss.by.direction = {0, 0, 0};
  EXPECT_FALSE(facts_of(m.query, m.witness, m.loss).overlap);
  m.loss.by.direction = {kInfinity, 0, 0};
  EXPECT_FALSE(facts_of(m.query, m.witness, m.loss).overlap);
}

}  // namespace
}  // namespace ccdfuzz
