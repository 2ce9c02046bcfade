#include "hunt/population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "eval/by_spec.hpp"
#include "hunt/draw.hpp"

namespace ccdfuzz {
namespace {

/// Told from others by its t_max.
WitnessedQuery numbered(double t_max) {
  WitnessedQuery q = falling_point();
  q.query.t_max = t_max;
  return q;
}

std::set<double> numbers_in(const Population& population) {
  std::set<double> found;
  Random random(1);
  for (int i = 0; i < 200; ++i) found.insert(population.any(random).query.t_max);
  return found;
}

TEST(Population, KeepsTheNearestOfEachNicheAndOfEqualsTheYounger) {
  const Niche one{Niche::By::kGap, 3, 1}, other{Niche::By::kGap, 3, 2};
  Population population;
  EXPECT_TRUE(population.empty());
  population.join(numbered(10), {one, 1.0});
  population.join(numbered(11), {one, 2.0});
  population.join(numbered(12), {other, 5.0});
  EXPECT_EQ(numbers_in(population), (std::set<double>{10, 12}));
  population.join(numbered(13), {one, 1.0});
  population.join(numbered(14), {other, 4.0});
  EXPECT_EQ(numbers_in(population), (std::set<double>{13, 14}));
}

TEST(Population, PrefersTheNearer) {
  Population population;
  population.join(numbered(10), {{Niche::By::kGap, 0, 0}, 1.0});
  population.join(numbered(11), {{Niche::By::kGap, 0, 1}, 2.0});
  int nearer = 0;
  constexpr int kDraws = 1000;
  Random random(1);
  for (int i = 0; i < kDraws; ++i) {
    nearer += population.nearer_of_two(random).query.t_max == 10 ? 1 : 0;
  }
  // 3 in 4; half would be 500 ± 5 standard deviations of 16.
  EXPECT_GT(nearer, 580);
}

// A power of two changes no rounding, and so not how near its errors come.
TEST(Standing, DoesNotDependOnTheScaleOfSpace) {
  TracerSet tracers;
  int compared = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    for (const Case& asked : draw(ContactClass::kVV, 1, i).asked) {
      std::optional<WitnessedQuery> q = witnessed_query(asked);
      if (!q) continue;
      WitnessedQuery scaled = *q;
      for (MovingPatch<double>& patch : scaled.query.patches) {
        for (Points<double>* points : {&patch.positions, &patch.velocities}) {
          for (Vec3<double>& p : *points) p *= 0x1p7;
        }
      }
      const auto standing = [&](const WitnessedQuery& of) {
        return standing_of(of, tracers["tdibm"].trace(of.query, of.witness(), {}));
      };
      const Standing a = standing(*q), b = standing(scaled);
      if (a.niche.by == Niche::By::kNothing) continue;
      ++compared;
      EXPECT_EQ(a.niche, b.niche) << i;
      EXPECT_EQ(a.nearness, b.nearness) << i;
      EXPECT_FALSE(std::isnan(a.nearness)) << i;
    }
  }
  EXPECT_GT(compared, 10);
}

}  // namespace
}  // namespace ccdfuzz
