#include "numeric/dyadic.hpp"

#include <bit>
#include <cmath>

#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

Dyadic any_dyadic() {
  return {Integer(static_cast<long>(*rc::gen::arbitrary<std::int64_t>())),
          *rc::gen::inRange(-200L, 200L)};
}

RC_GTEST_PROP(Dyadic, AgreesWithRational, ()) {
  const Dyadic a = any_dyadic(), b = any_dyadic();
  const Rational x = a.rational(), y = b.rational();
  RC_ASSERT((a + b).rational() == x + y);
  RC_ASSERT((a - b).rational() == x - y);
  RC_ASSERT((a * b).rational() == x * y);
  RC_ASSERT((a < b) == (x < y));
  RC_ASSERT((a == b) == (x == y));
  RC_ASSERT(Dyadic::from(x) == a);
}

RC_GTEST_PROP(Dyadic, EqualValuesHaveEqualFields, ()) {
  const Dyadic a = any_dyadic(), b = any_dyadic();
  const Dyadic c = (a + b) - b;
  RC_ASSERT(c == a);
  RC_ASSERT(c.mantissa() == a.mantissa());
  RC_ASSERT(c.exponent() == a.exponent());
}

RC_GTEST_PROP(Dyadic, RoundTripsDoubles, ()) {
  const double x = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  RC_PRE(std::isfinite(x));
  RC_ASSERT(Dyadic::exact(x).to_double_exactly() == std::optional<double>(x));
  RC_ASSERT(Dyadic::exact(x).rational() == exact(x));
}

TEST(Dyadic, RefusesWhatIsNotADouble) {
  EXPECT_FALSE(Dyadic(1, -1075).to_double_exactly());
  EXPECT_FALSE(Dyadic(1, 1024).to_double_exactly());
  EXPECT_FALSE((Dyadic(1, 53) + Dyadic(1)).to_double_exactly());
  EXPECT_FALSE(Dyadic::from(Rational(1, 3)));
}

}  // namespace
}  // namespace ccdfuzz
