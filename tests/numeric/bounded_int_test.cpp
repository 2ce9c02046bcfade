#include "numeric/bounded_int.hpp"

#include <cmath>
#include <cstdint>

#include "numeric/rational.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

using Int = BoundedInt<1024>;

Integer to_integer(const Int& x) {
  Integer r = 0;
  for (int i = x.limbs(); i-- > 0;) {
    r <<= 64;
    r += Integer(static_cast<unsigned long>(x.limb(i)));
  }
  return x.sign() < 0 ? Integer(-r) : r;
}

/// Of at most 8 limbs, so that the product of two fits, many of them such that carries go far.
Int any_int() {
  const auto any_limb = [] {
    return *rc::gen::oneOf(rc::gen::arbitrary<std::int64_t>(),
                           rc::gen::element<std::int64_t>(0, 1, -1, INT64_MIN, INT64_MAX));
  };
  Int x(any_limb());
  for (int n = *rc::gen::inRange(0, 7); n > 0; --n) {
    x = (x << *rc::gen::element(1, 63, 64)) + Int(any_limb());
  }
  return x;
}

RC_GTEST_PROP(BoundedInt, AgreesWithGmp, ()) {
  const Int a = any_int(), b = any_int();
  const int s = *rc::gen::inRange(0, 400);
  const Integer x = to_integer(a), y = to_integer(b);
  RC_LOG() << "a = " << x << "\nb = " << y << "\ns = " << s << "\n";
  RC_ASSERT(to_integer(a + b) == x + y);
  RC_ASSERT(to_integer(a - b) == x - y);
  RC_ASSERT(to_integer(-a) == -x);
  RC_ASSERT(to_integer(a * b) == x * y);
  RC_ASSERT(to_integer(a << s) == Integer(x << static_cast<mp_bitcnt_t>(s)));
  RC_ASSERT(a.sign() == sgn(x));
  Int c = a;
  c += c;
  RC_ASSERT(to_integer(c) == 2 * x);
  c -= c;
  RC_ASSERT(c.sign() == 0);
  const auto [mantissa, exponent] = a.approximate();
  const Rational error = exact(mantissa) * power_of_two(exponent) - Rational(x);
  RC_ASSERT(abs(error) <= abs(Rational(x)) * power_of_two(-52));
  RC_ASSERT(x == 0 || (0.5 <= std::abs(mantissa) && std::abs(mantissa) <= 1));
}

TEST(BoundedInt, ThrowsWhatDoesNotFit) {
  const Int top = Int(1) << 1023;
  EXPECT_EQ(to_integer(top - Int(1) + top), (Integer(1) << 1024) - 1);
  EXPECT_THROW(top + top, InternalError);
  EXPECT_THROW(top << 1, InternalError);
  EXPECT_THROW((Int(1) << 512) * (Int(1) << 512), InternalError);
}

}  // namespace
}  // namespace ccdfuzz
