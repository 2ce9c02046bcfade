// RapidCheck's generators are property-tested themselves: what they make, and what it shrinks to.
#include <algorithm>
#include <cmath>

#include "ccd/robustness.hpp"
#include "certify/checker/check_truth.hpp"
#include "generators/rc/cases.hpp"
#include "generators/rc/geometry.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

/// The value that a generator makes of a seed, and the first of what it shrinks to.
template <class T>
struct Family {
  T value;
  std::vector<T> shrinks;
};

template <class T>
Family<T> family_of(const rc::Gen<T>& gen, std::uint64_t seed, std::size_t most = 60) {
  const rc::Shrinkable<T> made = gen(rc::Random(seed), 100);
  Family<T> family{made.value(), {}};
  auto shrinks = made.shrinks();
  while (family.shrinks.size() < most) {
    auto next = shrinks.next();
    if (!next) break;
    family.shrinks.push_back(next->value());
  }
  return family;
}

std::size_t bits_of(const Dyadic& x) {
  return x.sign() == 0 ? 0 : mpz_sizeinbase(x.mantissa().get_mpz_t(), 2);
}

RC_GTEST_PROP(RcGenerators, DyadicsStayInTheirRangeAndShrinkToFewerBits, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::dyadic(20, -10, 30), seed);
  RC_ASSERT(bits_of(family.value) <= 20U);
  for (const Dyadic& x : family.shrinks) {
    RC_ASSERT(bits_of(x) <= 20U);
    RC_ASSERT(x.sign() == 0 || x.exponent() >= -10);
    RC_ASSERT(x.to_double_exactly().has_value());
  }
}

RC_GTEST_PROP(RcGenerators, NeighboursAreWithinReach, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::neighbours(30, 3), seed);
  const auto within = [](const std::array<double, 2>& pair) {
    if (pair[0] == 0) return std::abs(pair[1]) <= 0x1.8p-59;  // 3·2^-60
    double lo = pair[0], hi = pair[0];
    for (int i = 0; i < 3; ++i)
      lo = std::nextafter(lo, -HUGE_VAL), hi = std::nextafter(hi, HUGE_VAL);
    return lo <= pair[1] && pair[1] <= hi;
  };
  RC_ASSERT(within(family.value));
  for (const auto& pair : family.shrinks) RC_ASSERT(within(pair));
}

RC_GTEST_PROP(RcGenerators, LatticePointsAreSmallAndShrinkTowardsZero, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::lattice_points(Shape::tensor(2, 1)), seed);
  const auto weight = [](const Points<Dyadic>& points) {
    int sum = 0;
    for (const Vec3<Dyadic>& p : points) {
      for (int k = 0; k < 3; ++k) sum += p[k].sign() == 0 ? 0 : 1;
    }
    return sum;
  };
  for (const Vec3<Dyadic>& p : family.value) {
    for (int k = 0; k < 3; ++k) RC_ASSERT(abs(p[k]) <= Dyadic(2));
  }
  if (weight(family.value) == 0) return;
  RC_ASSERT(std::ranges::any_of(family.shrinks,
                                [&](const auto& s) { return weight(s) < weight(family.value); }));
}

RC_GTEST_PROP(RcGenerators, ConcurrentLinesHaveAPhiOfAFewUlps, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::near_concurrent_lines(3), seed);
  const auto check = [](const rc_gen::NearConcurrent& drawn) {
    const auto& [x, y, z] = drawn.lines;
    RC_ASSERT(x.slope < y.slope);
    RC_ASSERT(y.slope < z.slope);
    const ProductDifference<double> phi{z.slope - x.slope, y.intercept - x.intercept,
                                        y.slope - x.slope, z.intercept - x.intercept};
    // Each intercept is below 2^9: 3 floats and a rounding of 2^-44 each, slopes differ by < 4.
    RC_ASSERT(std::abs(phi.value()) <= 0x1p-38);
    RC_ASSERT(std::abs(x.at(drawn.t) - z.at(drawn.t)) <= 0x1p-40);
  };
  check(family.value);
  for (const auto& drawn : family.shrinks) check(drawn);
}

RC_GTEST_PROP(RcGenerators, ParallelLinesAreNearlyParallelAndCrossNearby, (std::uint64_t seed)) {
  for (const auto& [x, y] : family_of(rc_gen::near_parallel_lines(4), seed).shrinks) {
    RC_ASSERT(std::abs(x.slope - y.slope) <= 0x1p-46);
    RC_ASSERT(std::abs(x.at(2) - y.at(2)) <= 0x1p-40);
  }
}

RC_GTEST_PROP(RcGenerators, CellsAreCellsOfTheirShape, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::deep_cell(3, 40), seed);
  const auto check = [](const rc_gen::DeepCell& drawn) {
    RC_ASSERT(drawn.shape.valid());
    RC_ASSERT(drawn.cell.depth <= 40);
    for (const auto& uv : drawn.cell.corners(drawn.shape)) RC_ASSERT(drawn.shape.contains(uv));
  };
  check(family.value);
  for (const auto& drawn : family.shrinks) check(drawn);
}

RC_GTEST_PROP(RcGenerators, ContactsKeepAnExactWitnessHoweverTheyShrink, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::contact_case(), seed, 20);
  RC_ASSERT(check_truth(family.value).has_value());
  for (const Case& made : family.shrinks) {
    RC_ASSERT(made.truth.witness.has_value());
    RC_ASSERT(check_truth(made).has_value());
  }
}

RC_GTEST_PROP(RcGenerators, GeneratedCasesAreTrueHoweverTheyShrink, (std::uint64_t seed)) {
  const auto family = family_of(rc_gen::generated_case(), seed, 2);
  RC_ASSERT(check_truth(family.value).has_value());
  for (const Case& made : family.shrinks) RC_ASSERT(check_truth(made).has_value());
}

/// A failing contact shrinks, through RapidCheck alone, to one with next to nothing in it.
TEST(RcGenerators, AContactShrinksToPointsAtRest) {
  const auto small = [](const Case& made) {
    std::size_t size = 0;
    for (const auto& patch : made.query.patches) size += patch.positions.size();
    return size;
  };
  rc::Shrinkable<Case> now = rc_gen::contact_case()(rc::Random(std::uint64_t{7}), 100);
  const std::size_t at_first = small(now.value());
  for (bool moved = true; moved;) {
    moved = false;
    auto shrinks = now.shrinks();
    if (auto next = shrinks.next()) now = *next, moved = true;
  }
  EXPECT_EQ(small(now.value()), 2U) << "from " << at_first;
  EXPECT_EQ(now.value().query.t_max, 1.0);
}

}  // namespace
}  // namespace ccdfuzz
