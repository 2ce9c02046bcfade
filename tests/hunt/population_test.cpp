#include "hunt/population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "case/scale.hpp"
#include "hunt/draw.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {
namespace {

/// Its t_max identifies it.
Contact numbered(double t_max) {
  Contact q = falling_point();
  q.query.t_max = t_max;
  return q;
}

std::set<double> numbers_in(const Population& population) {
  std::set<double> found;
  Draw random{Random(1)};
  for (int i = 0; i < 200; ++i) found.insert(population.nearer_of_two(random).query.t_max);
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
  Draw random{Random(1)};
  for (int i = 0; i < kDraws; ++i) {
    nearer += population.nearer_of_two(random).query.t_max == 10 ? 1 : 0;
  }
  // 3 in 4. Half would be 500, and 580 is 5 standard deviations above that.
  EXPECT_GT(nearer, 580);
}

/// The contact of q, with space and time scaled by powers of two.
Contact scaled(const Contact& q, double space, int time) {
  Contact other = q;
  for (MovingPatch<double>& patch : other.query.patches) {
    for (Vec3<double>& p : patch.positions) p *= space;
    for (Vec3<double>& v : patch.velocities) v *= std::ldexp(space, -time);
  }
  other.query.t_max = std::ldexp(q.query.t_max, time);
  other.t = q.t.scaled(time);
  return other;
}

std::vector<Contact> drawn_contacts(ContactClass contact, std::uint64_t draws) {
  std::vector<Contact> found;
  for (std::uint64_t i = 0; i < draws; ++i) {
    for (const CheckedCase& asked : Draws(1).at(contact, i)) {
      if (std::optional<Contact> q = contact_of(asked.value())) found.push_back(*std::move(q));
    }
  }
  return found;
}

Standing standing_by(const std::string& method, const Contact& q) {
  MethodSet methods;
  return standing_of(q, methods[method].trace(q.query, q.witness(), {}));
}

// A power of two changes no rounding, and so not how near its errors come.
TEST(Standing, DoesNotDependOnTheScaleOfSpaceOrTime) {
  int compared = 0;
  for (const Contact& q : drawn_contacts(ContactClass::kVV, 40)) {
    if (!is_within_scale(q.query, 100)) continue;
    const Standing a = standing_by("tdibm", q), b = standing_by("tdibm", scaled(q, 0x1p7, 5));
    EXPECT_FALSE(std::isnan(a.nearness));
    if (std::isinf(a.nearness)) continue;
    ++compared;
    EXPECT_EQ(a.niche, b.niche);
    EXPECT_EQ(a.nearness, b.nearness);
  }
  EXPECT_GT(compared, 10);
}

// A double next to 0 is no nearer to it than rounding makes of heights.
TEST(Standing, AContactAtTheStartIsNotNearForThat) {
  Contact q = falling_point();
  q.t = Dyadic(0);
  Trace trace;
  trace.margin = Trace::Margin{};
  trace.margin->by.direction = {0, 0, 1};
  trace.margin->by.times = {0.5, 1, false, true};
  for (MovingPatch<double>& patch : q.query.patches) {
    for (Vec3<double>& p : patch.positions) p = {0, 0, 1};
    for (Vec3<double>& v : patch.velocities) v = {0, 0, 0};
  }
  for (Vec3<double>& v : q.query.patches[0].velocities) v = {0, 0, -1};
  // They are 0.5 apart then, of heights of 1.
  EXPECT_EQ(standing_of(q, trace).nearness, 0x1p52);
  EXPECT_EQ(standing_of(q, trace).niche.by, Niche::By::kExcludedRest);
}

TEST(Standing, IsTheSlackOfMethodsThatCompareAndNothingWhereNothingWasExcluded) {
  Trace trace;
  EXPECT_EQ(standing_of(falling_point(), trace).niche, Niche{});
  trace.margin = Trace::Margin{};
  trace.slack = Trace::Slack{};
  trace.slack->value = 3;
  trace.slack->place.level = 4;
  trace.slack->gap.axis = 5;
  EXPECT_EQ(standing_of(falling_point(), trace).niche, (Niche{Niche::By::kGap, 4, 5}));
  EXPECT_EQ(standing_of(falling_point(), trace).nearness, 3);
}

}  // namespace
}  // namespace ccdfuzz
