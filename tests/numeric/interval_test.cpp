#include "numeric/interval.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kMax = std::numeric_limits<double>::max();

/// Any finite double, with exponents that make sums cancel and products under- and overflow.
double any_double() {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>() * 0x9e3779b97f4a7c15ULL;
  const double m = std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits)), -63);
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return m;
    case 1:
      return std::ldexp(m, *rc::gen::inRange(-60, 60));
    case 2:
      return std::ldexp(m, *rc::gen::inRange(-1074, 1025));
    case 3:
      return *rc::gen::element(0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1p-1074, kMax, -kMax, 0x1p-537);
    default:
      return std::ldexp(m, *rc::gen::inRange(-560, -460));  // products around the least double
  }
}

Interval any_interval() {
  const double x = any_double(), y = *rc::gen::inRange(0, 2) == 0 ? x : any_double();
  RC_PRE(std::isfinite(x) && std::isfinite(y));
  return {std::min(x, y), std::max(x, y)};
}

/// A member of x: an end or a point between.
Rational member(const Interval& x) {
  const Rational lo = exact(x.lo()), hi = exact(x.hi());
  const Rational s(*rc::gen::inRange(0, 5), 4);
  return lo + s * (hi - lo);
}

std::string text(const Interval& x) {
  return fmt::format("[{:a}, {:a}]", x.lo(), x.hi());
}

void expect_tight(const Rational& exact_value, const Interval& result) {
  RC_ASSERT(result == Interval::enclosing(exact_value));
}

RC_GTEST_PROP(Interval, EnclosesEveryExactResult, ()) {
  const Interval a = any_interval(), b = any_interval();
  const Rational x = member(a), y = member(b);
  RC_LOG() << text(a) << " " << text(b) << "\n" << x << " " << y << "\n";
  RC_ASSERT((a + b).contains(x + y));
  RC_ASSERT((a - b).contains(x - y));
  RC_ASSERT((a * b).contains(x * y));
  RC_ASSERT((-a).contains(-x));
  RC_ASSERT(hull(a, b).contains(x));
  RC_ASSERT(hull(a, b).contains(y));
  if (const auto s = (a * b).sign()) RC_ASSERT(*s == sgn(Rational(x * y)));
}

RC_GTEST_PROP(Interval, SumsOfNumbersAreAsTightAsDoublesAllow, ()) {
  const double x = any_double(), y = any_double();
  RC_PRE(std::isfinite(x) && std::isfinite(y));
  RC_LOG() << to_hex(x) << " " << to_hex(y) << "\n";
  expect_tight(exact(x) + exact(y), Interval(x) + Interval(y));
}

RC_GTEST_PROP(Interval, ProductsAboveTheUnderflowAreAsTightAsDoublesAllow, ()) {
  const double x = any_double(), y = any_double();
  RC_PRE(std::isfinite(x) && std::isfinite(y));
  const Rational product = exact(x) * exact(y);
  RC_PRE(abs(product) >= power_of_two(-959));
  RC_LOG() << to_hex(x) << " " << to_hex(y) << "\n";
  expect_tight(product, Interval(x) * Interval(y));
}

TEST(Interval, OverflowOpensOneEndOnly) {
  EXPECT_EQ(Interval(kMax) + Interval(kMax), Interval(kMax, kInf));
  EXPECT_EQ(Interval(-kMax) * Interval(2), Interval(-kInf, -kMax));
  EXPECT_EQ(Interval(0) * Interval(-kInf, kInf), Interval(0));
}

TEST(Interval, UnderflowNeverHidesTheSign) {
  const Interval tiny = Interval(0x1p-600) * Interval(0x1p-600);
  EXPECT_EQ(tiny.hi(), 0x1p-1074);
  EXPECT_TRUE(tiny.contains(power_of_two(-1200)));
  EXPECT_FALSE(tiny.sign());
  EXPECT_EQ(*(Interval(0x1p-600) * Interval(0.0)).sign(), 0);
}

}  // namespace
}  // namespace ccdfuzz
