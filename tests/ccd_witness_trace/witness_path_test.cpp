#include "ccd/witness_trace/witness_path.hpp"
#include "bezier/exact_patch.hpp"

#include "bezier/random_patch.hpp"

namespace ccdfuzz {
namespace {

/// A rational in [0, 1]: dyadic and on the edges of cells half of the time.
Rational any_fraction() {
  const long denominator = *rc::gen::oneOf(rc::gen::element(1L, 2L, 8L, 1L << 40, 1L << 60),
                                           rc::gen::inRange(1L, 1000L));
  const long numerator = *rc::gen::oneOf(rc::gen::inRange(0L, std::min(denominator, 20L) + 1),
                                         rc::gen::inRange(0L, denominator + 1));
  Rational out(numerator, denominator);
  out.canonicalize();
  return out;
}

Uv<Rational> any_rational_uv(const Shape& shape) {
  if (shape.parameter_count() == 0) return {};
  Rational u = any_fraction();
  if (shape.parameter_count() == 1) return {u, Rational(0)};
  Rational v = any_fraction();
  if (shape.kind == ShapeKind::kTriangle) {
    if (*rc::gen::arbitrary<bool>()) {
      v *= 1 - u;  // anywhere, the diagonal included
    } else if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
  }
  return {u, v};
}

RC_GTEST_PROP(WitnessPath, ContainsWhatCellsContain, ()) {
  const std::array<Shape, 2> shapes = {*any_shape(), *any_shape()};
  Witness witness;
  for (size_t s = 0; s < 2; ++s) witness.uv[s] = any_rational_uv(shapes[s]);
  WitnessPath path;
  path.assign(shapes, witness);
  for (int s = 0; s < 2; ++s) {
    const Shape& shape = shapes[static_cast<size_t>(s)];
    const Uv<Rational>& uv = witness.uv[static_cast<size_t>(s)];
    Cell cell;
    while (cell.depth < Cell::kMaxDepth) {
      std::optional<Cell> next;
      for (int c = 0; c < shape.child_count(); ++c) {
        const Cell child = cell.child(shape, c);
        RC_ASSERT(path.in(s, child) == contains(child, shape, uv));
        if (path.in(s, child) && (!next || *rc::gen::arbitrary<bool>())) next = child;
      }
      RC_ASSERT(next.has_value());
      cell = *next;
    }
  }
}

TEST(TimeBounds, ATimeBetweenDoublesIsNoneOfThem) {
  const double below = 1, above = std::nextafter(1., 2.);
  const TimeBounds between{below, above}, at{below, below};
  EXPECT_FALSE(between.within(TimeWindow<double>{0, below}));
  EXPECT_FALSE(between.within(TimeWindow<double>{above, 2}));
  EXPECT_TRUE(between.within(TimeWindow<double>{below, above}));
  EXPECT_TRUE(at.within(TimeWindow<double>{0, below}));
  EXPECT_TRUE(between.within(SeparatedInterval<double>{below, above, false, false}));
  EXPECT_FALSE(between.within(SeparatedInterval<double>{0, below, true, true}));
  EXPECT_TRUE(at.within(SeparatedInterval<double>{0, below, true, true}));
  EXPECT_FALSE(at.within(SeparatedInterval<double>{0, below, true, false}));
  EXPECT_FALSE(at.within(SeparatedInterval<double>{below, 2, false, true}));
}

}  // namespace
}  // namespace ccdfuzz
