// Each tier of tdibm-c decides something.
#include <gtest/gtest.h>

#include <random>

#include "ccd/certified/tdibm_c.hpp"

namespace ccdfuzz {
namespace {

MovingPatch<double> random_patch(std::mt19937_64& random, const Shape& shape, double offset) {
  std::uniform_real_distribution<double> any(-1, 1);
  MovingPatch<double> patch{shape, {}, {}};
  const Vec3<double> v(any(random), any(random), any(random));
  for (int i = 0; i < shape.control_count(); ++i) {
    patch.positions.push_back({any(random), any(random), any(random) + offset});
    const Vec3<double> own(any(random), any(random), any(random) - offset);
    patch.velocities.push_back(v + 0.5 * own);
  }
  return patch;
}

std::uint64_t of_linear_queries(const certified::Tiers& tiers) {
  return tiers.advancement + tiers.doubles + tiers.integers;
}

TEST(Tiers, EachOfTheGeneralSearchDecides) {
  std::mt19937_64 random(1);
  TdibmC method;
  for (int i = 0; i < 100; ++i) {
    Query query;
    for (auto& patch : query.patches) patch = random_patch(random, Shape::triangle(2), i % 3);
    method.answer(query, {.precision = 0x1p-10, .max_pops = 200});
  }
  const certified::Tiers tiers = method.tiers();
  EXPECT_GT(tiers.coordinate, 0U);
  EXPECT_GT(tiers.shared, 0U);
  EXPECT_GT(tiers.own, 0U);
  EXPECT_GT(tiers.together, 0U);
  EXPECT_GT(tiers.chord, 0U);
  EXPECT_GT(tiers.newton, 0U);
  EXPECT_GT(tiers.postponed, 0U);
  EXPECT_EQ(of_linear_queries(tiers), 0U);
}

TEST(Tiers, EachOfLinearQueriesDecides) {
  std::mt19937_64 random(2);
  TdibmC method;
  constexpr std::uint64_t kQueries = 100;
  for (std::uint64_t i = 0; i < kQueries; ++i) {
    Query query;
    query.patches = {random_patch(random, Shape::point(), 0),
                     random_patch(random, Shape::triangle(1), 0)};
    // Some are in one plane for all times, and others touch at an edge or a vertex, as their
    // numbers are −1, 0 and 1: integers can tell.
    for (auto& patch : query.patches) {
      for (auto* points : {&patch.positions, &patch.velocities}) {
        for (Vec3<double>& p : *points) {
          if (i % 4 == 0) p[2] = 0;
          if (i % 4 == 1) p = p.array().round();
        }
      }
    }
    method.answer(query, {});
  }
  const certified::Tiers tiers = method.tiers();
  EXPECT_GT(tiers.advancement, 0U);
  EXPECT_GT(tiers.doubles, 0U);
  EXPECT_GT(tiers.integers, 0U);
  EXPECT_EQ(of_linear_queries(tiers), kQueries);
}

}  // namespace
}  // namespace ccdfuzz
