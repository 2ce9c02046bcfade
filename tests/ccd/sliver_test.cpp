#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ccd/tdibm.hpp"
#include "generators/random.hpp"
#include "numeric/effort.hpp"

namespace ccdfuzz {
namespace {

Vec3<double> random_vector(Random& random) {
  Vec3<double> v;
  for (int k = 0; k < 3; ++k) {
    v[k] = std::ldexp(static_cast<double>(random.below(1 << 20)), -19) - 1;
  }
  return v;
}

/// A triangular quadratic about 1 long whose edges from the first corner are `apart` from parallel:
/// its normal, made of unit spans, is about `apart` long.
MovingPatch<double> sliver(Random& random, double apart) {
  const Vec3<double> u = random_vector(random), across = apart * random_vector(random);
  MovingPatch<double> patch{Shape::triangle(2), {}, {}};
  const Vec3<double> v = u + across;
  for (const auto& [i, j] : {std::pair(0, 0), {0, 1}, {0, 2}, {1, 0}, {1, 1}, {2, 0}}) {
    const Vec3<double> bend = (i == 1 || j == 1 ? .125 * apart : 0) * random_vector(random);
    patch.positions.push_back((.5 * i) * u + (.5 * j) * v + bend);
  }
  patch.velocities.assign(6, Vec3<double>(0, 0, 0));
  return patch;
}

/// Two slivers on both sides of a plane that approach it and at t_max end `gap` apart from it.
Query apart_by(Random& random, double apart, double gap) {
  Query query;
  query.t_max = 1;
  const Vec3<double> side = random_vector(random);
  const Vec3<double> normal = side / std::sqrt(dot(side, side));
  for (int s = 0; s < 2; ++s) {
    MovingPatch<double>& patch = query.patches[static_cast<size_t>(s)];
    patch = sliver(random, apart);
    const double sign = s == 0 ? -1 : 1;
    double least = sign * dot(normal, patch.positions[0]);
    for (const Vec3<double>& p : patch.positions) least = std::min(least, sign * dot(normal, p));
    for (Vec3<double>& p : patch.positions) p += sign * (gap - least + 1) * normal;
    patch.velocities.assign(6, -sign * normal);
  }
  return query;
}

struct FalseHits {
  int appendix_a = 0, unit = 0, plain = 0;
};

FalseHits of_slivers(int exponent, int count) {
  Tdibm<ErrorBoundIntended> appendix_a;
  Tdibm<ErrorBoundIntended> unit({}, {{AxisReading::Spans::kCorners, AxisReading::Length::kUnit}});
  Tdibm<Plain> plain;
  const SearchOptions options;
  FalseHits out;
  for (int i = 0; i < count; ++i) {
    Random random = Random::keyed({static_cast<std::uint64_t>(i)});
    const double gap = std::ldexp(1.5, -static_cast<int>(random.below(31)));
    const Query query = apart_by(random, std::ldexp(1, exponent), gap);
    out.appendix_a += appendix_a.answer(query, options).verdict == Verdict::kHit ? 1 : 0;
    out.unit += unit.answer(query, options).verdict == Verdict::kHit ? 1 : 0;
    out.plain += plain.answer(query, options).verdict == Verdict::kHit ? 1 : 0;
  }
  return out;
}

/// The claim of DERIVATION.md, "Readings": the shorter the axes, the less the error-bounded method
/// can tell apart, since its bounds are made for axes of unit length.
TEST(Slivers, ShortAxesMakeFalseHitsOfTheErrorBoundedMethod) {
  const int count = 10 * static_cast<int>(effort().value());
  for (const int exponent : {0, -10, -20, -30, -40, -48}) {
    const FalseHits hits = of_slivers(exponent, count);
    fmt::print(
        "edges 2^{} apart, {} pairs, false hits: tdibm-e {}, tdibm-e@unit-axes {}, tdibm {}\n",
        exponent, count, hits.appendix_a, hits.unit, hits.plain);
    EXPECT_LE(hits.unit, hits.appendix_a);
    if (exponent == -48) {
      EXPECT_GE(hits.appendix_a, count / 2);
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
