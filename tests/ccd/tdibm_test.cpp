#include "ccd/tdibm.hpp"

#include <gtest/gtest.h>

#include "random_query.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

SearchOptions with_precision(double precision) {
  SearchOptions options;
  options.precision = precision;
  return options;
}

TEST(Tdibm, PulledApartEnvelopesFindContactsOfRandomPatches) {
  constexpr std::array kShapes = {Shape::point(),     Shape::curve(1),    Shape::curve(3),
                                  Shape::triangle(1), Shape::triangle(2), Shape::tensor(2, 1),
                                  Shape::tensor(3, 3)};
  Tdibm<PullApart> absolute(PullApart(1e-12, PullUnit::kLength)), relative(PullApart(1e-12));
  for (std::uint64_t key = 0; key < 147; key += kOneIn) {
    Query query = random_query(kShapes[key % 7], kShapes[key / 7 % 7], key);
    // The first corners meet at t = 1/2, exactly.
    auto& [first, second] = query.patches;
    const Vec3<double> way = first.at(.5)[0] - second.at(.5)[0];
    for (Vec3<double>& p : second.positions) p += way;
    for (const Answer& answer : {absolute.answer(query, with_precision(1e-3)),
                                 relative.answer(query, with_precision(1e-3))}) {
      EXPECT_EQ(answer.verdict, Verdict::kHit) << key;
      // Nothing of it claims to be in time to the last bit.
      EXPECT_LE(answer.toi.value_or(2), .5 + 0x1p-40) << key;
    }
  }
}

TEST(Tdibm, HighestDegreesAreAnswered) {
  Tdibm<ErrorBoundIntended> method;
  for (const Shape& shape : {Shape::tensor(8, 8), Shape::triangle(8)}) {
    EXPECT_EQ(method.answer(twice_the_same(shape), with_precision(1e-2)).verdict, Verdict::kHit);
  }
}

/// Two quadratic triangles that touch transversally at t = 3/4, at (0, 0) of patch 1 and (1/4, 1/4)
/// of patch 2. The first contact is at about 0.742. On the axis z the control points of patch 1
/// make a twin shield: one line that is redundant by 1e-16 hides another that is redundant by much
/// more.
Query twin_shield() {
  const auto triangle = [](std::array<std::array<double, 3>, 6> p, std::array<double, 6> vz) {
    MovingPatch<double> patch{Shape::triangle(2), {}, {}};
    for (size_t i = 0; i < 6; ++i) {
      patch.positions.push_back({p[i][0], p[i][1], p[i][2]});
      patch.velocities.push_back({0, 0, vz[i]});
    }
    return patch;
  };
  // Order: w², vw, v², uw, uv, u².
  Query query;
  query.patches[0] =
      triangle({{{0, 0, -1}, {0, 4, -.25}, {0, 8, 0}, {4, 0, -.25}, {4, 4, 0}, {8, 0, 0}}},
               {2, .1 * 3, 0, .3, 0, 0});
  query.patches[1] = triangle({{{-.25, -.25, -7},
                                {-.25, .25, -7},
                                {-.25, .75, -7},
                                {.25, -.25, -7},
                                {.25, .25, -7},
                                {.75, -.25, -7}}},
                              {10, 10, 10, 10, 10, 10});
  query.t_max = 1;
  return query;
}

TEST(TwinShield, PlainAndIntendedErrorBoundReportTheContact) {
  const Query query = twin_shield();
  Tdibm<Plain> plain;
  Tdibm<ErrorBoundIntended> error_bound;
  for (const Answer& answer : {plain.answer(query, with_precision(1e-2)),
                               error_bound.answer(query, with_precision(1e-2))}) {
    EXPECT_EQ(answer.verdict, Verdict::kHit);
    EXPECT_NEAR(answer.toi.value_or(-1), .742, .001);
  }
}

TEST(TwinShield, PrintedSignMissesTheContact) {
  Tdibm<ErrorBoundPrinted> printed;
  EXPECT_EQ(printed.answer(twin_shield(), with_precision(1e-2)).verdict, Verdict::kMiss);
}

}  // namespace
}  // namespace ccdfuzz
