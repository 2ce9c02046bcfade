#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "ccd/certified/tdibm_c.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {
namespace {

MovingPatch<double> triangle(double z, double vz, double scale) {
  MovingPatch<double> patch{Shape::triangle(1), {{0, 0, z}, {0, 1, z}, {1, 0, z}}, {}};
  for (auto& p : patch.positions) p *= scale;
  patch.velocities.assign(3, {0, 0, vz * scale});
  return patch;
}

Answer ask(const Query& query) {
  return TdibmC().answer(query, {.precision = 0x1p-8, .max_pops = 20000});
}

TEST(TdibmC, KeepsAContactAtExactlyTheEndOfTime) {
  for (const double scale : {1.0, 0x1p-1000, 0x1p-1060, 0x1p900, 0x1p1019}) {
    const Query query{{triangle(0, 0, scale), triangle(1, -1, scale)}, 1};
    const Answer answer = ask(query);
    EXPECT_EQ(answer.verdict, Verdict::kHit) << to_hex(scale);
    EXPECT_LE(answer.toi.value_or(2), 1) << to_hex(scale);
    EXPECT_GE(answer.toi.value_or(0), 0.9) << to_hex(scale);
  }
}

TEST(TdibmC, ProvesAMissJustBeforeTheContact) {
  for (const double scale : {1.0, 0x1p-1000, 0x1p900, 0x1p1019}) {
    const Query query{{triangle(0, 0, scale), triangle(1, -1, scale)}, 1 - 0x1p-30};
    EXPECT_EQ(ask(query).verdict, Verdict::kMiss) << to_hex(scale);
  }
}

TEST(TdibmC, IsNotLateWherePositionsOrVelocitiesAreTheLargestDoubles) {
  for (const auto& [position, velocity] :
       {std::pair{1023, 1023}, std::pair{1023, 1000}, std::pair{1000, 1023}, std::pair{0, 1023}}) {
    Query query{{triangle(0, 0, 1), triangle(1, -1, 1)}, 0};
    for (MovingPatch<double>& patch : query.patches) {
      for (auto& p : patch.positions) p *= std::ldexp(1.0, position);
      for (auto& v : patch.velocities) v *= std::ldexp(1.0, velocity);
    }
    const double contact = std::ldexp(1.0, position - velocity);
    query.t_max = 4 * contact;
    const Answer answer = ask(query);
    EXPECT_EQ(answer.verdict, Verdict::kHit) << position << " " << velocity;
    EXPECT_LE(answer.toi.value_or(query.t_max), contact) << position << " " << velocity;
    EXPECT_GE(answer.toi.value_or(0), 0.9 * contact) << position << " " << velocity;
  }
}

TEST(TdibmC, KeepsContactsAtTimeZeroAndStaticOnes) {
  for (const double vz : {0.0, 1.0, -1.0}) {
    const Query query{{triangle(0, 0, 1), triangle(0, vz, 1)}, 1};
    const Answer answer = ask(query);
    EXPECT_NE(answer.verdict, Verdict::kMiss) << vz;
    EXPECT_EQ(answer.toi, 0.0) << vz;
  }
}

TEST(TdibmC, DecidesAtTMaxZero) {
  EXPECT_EQ(ask({{triangle(0, 5, 1), triangle(1, -5, 1)}, 0}).verdict, Verdict::kMiss);
  EXPECT_NE(ask({{triangle(0, 5, 1), triangle(0, -5, 1)}, 0}).verdict, Verdict::kMiss);
}

TEST(TdibmC, TimesAreRoundedDownWhereTheyAreSubnormal) {
  const double tiny = 3 * std::numeric_limits<double>::denorm_min();
  const Query query{{triangle(0, 0, 1), triangle(1, -0x1p1000, 1)}, tiny};
  EXPECT_EQ(ask(query).verdict, Verdict::kMiss);
  const Query touching{{triangle(0, 0, 1), triangle(0, 1, 1)}, tiny};
  EXPECT_EQ(ask(touching).toi, 0.0);
}

/// A curved patch, and the same one unit above, coming down to lie on it at t = 1.
Query area_contact() {
  const MovingPatch<double> curved{
      Shape::triangle(2),
      {{0, 0, 0}, {0, .5, .25}, {0, 1, 0}, {.5, 0, .25}, {.5, .5, .375}, {1, 0, 0}},
      std::vector<Vec3<double>>(6, {0, 0, 0})};
  Query query{{curved, curved}, 1};
  for (Vec3<double>& p : query.patches[1].positions) p[2] += 1;
  query.patches[1].velocities.assign(6, {0, 0, -1});
  return query;
}

TEST(TdibmC, MissesFarPatchesHoweverWideAHitMayBe) {
  Query far = area_contact();
  for (Vec3<double>& p : far.patches[1].positions) p[0] += 1000;
  EXPECT_EQ(TdibmC().answer(far, {.precision = 1}).verdict, Verdict::kMiss);
}

TEST(TdibmC, SeparatesNothingWhereRoundingIsInfinite) {
  constexpr double kLeast = std::numeric_limits<double>::denorm_min();
  Query query = area_contact();
  for (MovingPatch<double>& patch : query.patches) {
    patch.positions.assign(6, {0x1.8p1023, 0x1.8p1023, 0x1.8p1023});
    for (int i = 0; i < 6; ++i) patch.velocities[static_cast<size_t>(i)] = {i * kLeast, kLeast, 0};
  }
  query.t_max = kLeast;
  EXPECT_EQ(ask(query).verdict, Verdict::kHit);
}

TEST(TdibmC, EndsWithinTheDefaultBudgetsWherePatchesCoincideOverAnArea) {
  TdibmC method;
  const Answer answer = method.answer(area_contact(), {});
  EXPECT_EQ(answer.verdict, Verdict::kUndecided);
  EXPECT_EQ(answer.note, "memory budget exhausted");
  EXPECT_GT(answer.bytes, SearchOptions().max_bytes) << "what ended it";
  EXPECT_LE(answer.toi.value(), 1);  // a lower bound of the contact's time
  EXPECT_GE(answer.toi.value(), 1 - 0x1p-10);
  EXPECT_LE(answer.pops, 150'000U);
}

}  // namespace
}  // namespace ccdfuzz
