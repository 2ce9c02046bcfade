#include "ccd/rational/exact_scene.hpp"

#include "ccd_rational/exact_reference.hpp"
#include "ccd_rational/random_query.hpp"

namespace ccdfuzz::exact_ccd {
namespace {

constexpr int kAxisBits = 30;

/// Coordinates that are all ±(2^bits − 1), except one that is 1.
Points<double> extreme_points(const Shape& shape, int bits, bool positive) {
  const double largest = std::ldexp(1.0, bits) - 1;
  Points<double> points(static_cast<size_t>(shape.control_count()), {largest, largest, largest});
  for (Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) {
      if (!positive || *rc::gen::inRange(0, 16) == 0) p[k] = -largest;
    }
  }
  points[0][0] = 1;
  return points;
}

struct Limit {
  Query query;
  std::array<CellFamily, 2> families;
  int bits = 0;
};

/// A query and cells whose predicates need as many bits as possible, but ≤ `bits`.
Limit at_the_limit(int bits) {
  Limit limit;
  const int max_degree = std::min(bits / 64, kMaxDegree);
  const Shape a = *any_shape(max_degree), b = *any_shape(max_degree);
  const int depth = *rc::gen::inRange(0, bits < 256 ? 6 : 11);
  const int drift = *rc::gen::inRange(0, 10), mantissa = *rc::gen::inRange(1, bits < 256 ? 10 : 54);
  const double t_max = bits < 256 ? 0x1.fffp-500 : *rc::gen::element(1.0, 0x1.fffffffffffffp60);
  const bool below = *rc::gen::inRange(0, 2) == 0;
  const auto patch = [&](const Shape& shape, bool positive) {
    const Points<double> positions = extreme_points(shape, mantissa, positive);
    return MovingPatch<double>{shape, positions, extreme_points(shape, mantissa, positive)};
  };
  limit.query.t_max = t_max;
  limit.query.patches[0] = patch(a, below);
  limit.query.patches[1] = patch(b, !below);
  for (MovingPatch<double>& moving : limit.query.patches) {
    for (Vec3<double>& v : moving.velocities) {
      for (int k = 0; k < 3; ++k) v[k] = std::ldexp(v[k], -drift - parts_of(t_max).top());
    }
  }
  // The lowest bit is that of the velocities times the unit of time: raising the positions above it
  // a bit at a time reaches every number of bits.
  const auto needed = [&] { return Units::of(limit.query).bits_needed(kAxisBits, depth); };
  RC_PRE(needed() <= bits);
  for (Query raised = limit.query;;) {
    for (MovingPatch<double>& moving : raised.patches) {
      for (Vec3<double>& p : moving.positions) {
        for (int k = 0; k < 3; ++k) p[k] *= 2;
      }
    }
    if (Units::of(raised).bits_needed(kAxisBits, depth) > bits) break;
    limit.query = raised;
  }
  limit.bits = needed();
  limit.families = {any_family(a, depth), any_family(b, depth)};
  return limit;
}

template <int Bits>
void agrees_at_the_limit() {
  const Limit limit = at_the_limit(Bits);
  RC_CLASSIFY(limit.bits > Bits - 3);
  ExactScene<WideInt<Bits>> scene;
  scene.load(limit.query, Units::of(limit.query));
  const std::array<Cell, 2> cells = {limit.families[0].cell(), limit.families[1].cell()};
  constexpr std::int32_t most = std::int32_t{1} << kAxisBits;
  IntegerAxis axis{{most, most, most}};
  for (std::int32_t& x : axis.l) {
    if (*rc::gen::inRange(0, 8) == 0) x = *rc::gen::element(-most, 0, 1, most - 1);
  }
  const double t = *rc::gen::element(0.0, limit.query.t_max, limit.query.t_max);
  const std::vector<std::uint8_t> all(kMaxControls, 1);
  for (size_t below = 0; below < 2; ++below) {
    const auto lines = [&](size_t side) {
      return exact_lines(limit.query.patches[side], cells[side], axis);
    };
    const Rational gap = exact_gap(lines(below), lines(1 - below), exact(t));
    RC_LOG() << "needs " << limit.bits << " of " << Bits << " bits, depth " << cells[0].depth
             << ", gap " << gap.get_d() << "\n";
    RC_ASSERT(scene.gap_sign(static_cast<int>(below), cells, axis, t, {all, all}) == sgn(gap));
  }
}

// What has no bits at all, like the velocities of patches at rest, must not enter (a fuzzer saw an
// overflow here).
TEST(Units, AreOfThePositionsAloneWhereNothingMovesAndOfVelocitiesWhereAllBeginsAtTheOrigin) {
  Query query;
  query.t_max = 4;
  for (MovingPatch<double>& patch : query.patches) {
    patch = {Shape::curve(1), {{0.25, 0, 3}, {0, -7, 0}}, {{0, 0, 0}, {0, 0, 0}}};
  }
  const Units rest = Units::of(query);
  EXPECT_EQ(rest.length, -2);
  EXPECT_EQ(rest.magnitude_bits, 5);  // |p| < 2^3, in steps of 2^-2
  for (MovingPatch<double>& patch : query.patches) std::swap(patch.positions, patch.velocities);
  const Units from_origin = Units::of(query);
  EXPECT_EQ(from_origin.length, -2 + from_origin.time);
  EXPECT_EQ(from_origin.magnitude_bits, 3 + from_origin.horizon - from_origin.length);
}

RC_GTEST_PROP(ExactScene, HoldsTheLastBitOf128, ()) {
  agrees_at_the_limit<128>();
}
RC_GTEST_PROP(ExactScene, HoldsTheLastBitOf256, ()) {
  agrees_at_the_limit<256>();
}
RC_GTEST_PROP(ExactScene, HoldsTheLastBitOf512, ()) {
  agrees_at_the_limit<512>();
}

}  // namespace
}  // namespace ccdfuzz::exact_ccd
