#include "numeric/wide_int.hpp"

#include <limits>

#include "numeric/rational.hpp"
#include "rapidcheck.hpp"

namespace ccdfuzz {
namespace {

template <int Bits>
Integer to_integer(const WideInt<Bits>& x) {
  Integer r = 0;
  for (int i = Bits / 64; i-- > 0;) {
    r <<= 64;
    r += Integer(static_cast<unsigned long>(x.limb(i)));
  }
  if (x.sign() < 0) r -= Integer(1) << Bits;
  return r;
}

/// x modulo 2^Bits, in two's complement.
template <int Bits>
Integer wrapped(const Integer& x) {
  Integer r;
  mpz_fdiv_r_2exp(r.get_mpz_t(), x.get_mpz_t(), Bits);
  if (mpz_tstbit(r.get_mpz_t(), Bits - 1) != 0) r -= Integer(1) << Bits;
  return r;
}

/// Mostly limbs at which carries and borrows happen.
std::int64_t any_word() {
  constexpr auto kMin = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMax = std::numeric_limits<std::int64_t>::max();
  if (*rc::gen::inRange(0, 2) == 0) {
    return *rc::gen::element<std::int64_t>(0, 1, -1, 2, kMin, kMin + 1, kMax, kMax - 1);
  }
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  return static_cast<std::int64_t>(bits * 0x9e3779b97f4a7c15ULL);
}

/// Any bit pattern: sum of words at every limb.
template <int Bits>
WideInt<Bits> any_wide() {
  WideInt<Bits> x(any_word());
  for (int i = 1; i < Bits / 64; ++i) x = (x << 64) + WideInt<Bits>(any_word());
  if (*rc::gen::inRange(0, 3) == 0) x = WideInt<Bits>(any_word()) << *rc::gen::inRange(0, Bits);
  return x;
}

template <int Bits>
void agrees_with_gmp() {
  const WideInt<Bits> a = any_wide<Bits>(), b = any_wide<Bits>();
  const std::int64_t m = any_word();
  const int s = *rc::gen::inRange(0, Bits);
  const Integer x = to_integer(a), y = to_integer(b);
  RC_LOG() << "a = " << x << "\nb = " << y << "\nm = " << m << "\ns = " << s << "\n";
  RC_ASSERT(to_integer(a + b) == wrapped<Bits>(x + y));
  RC_ASSERT(to_integer(a - b) == wrapped<Bits>(x - y));
  RC_ASSERT(to_integer(-a) == wrapped<Bits>(-x));
  RC_ASSERT(to_integer(a * m) == wrapped<Bits>(x * Integer(static_cast<long>(m))));
  RC_ASSERT(to_integer(a << s) == wrapped<Bits>(Integer(x << static_cast<mp_bitcnt_t>(s))));
  RC_ASSERT(to_integer(WideInt<Bits>(m)) == Integer(static_cast<long>(m)));
  RC_ASSERT((a < b) == (x < y));
  RC_ASSERT((a > b) == (x > y));
  RC_ASSERT((a == b) == (x == y));
  RC_ASSERT(a.sign() == sgn(x));
}

template <int Bits, int Others>
void product_is_gmp() {
  const WideInt<Bits> a = any_wide<Bits>();
  const WideInt<Others> b = any_wide<Others>();
  const Integer x = to_integer(a), y = to_integer(b), product = to_integer(a * b);
  RC_LOG() << "a = " << x << "\nb = " << y << "\n";
  RC_ASSERT(product == x * y);
  RC_ASSERT(to_integer(WideInt<Bits + Others>(a)) == x);
  const Rational off = abs(exact((a * b).approximate()) - Rational(product));
  RC_ASSERT(off * power_of_two(52) <= Rational(abs(product)));
}

RC_GTEST_PROP(WideInt, ProductsOfAnyLengthsAreExact, ()) {
  product_is_gmp<128, 128>();
  product_is_gmp<128, 256>();
  product_is_gmp<256, 128>();
}

RC_GTEST_PROP(WideInt, AgreesWithGmpModulo2To128, ()) {
  agrees_with_gmp<128>();
}
RC_GTEST_PROP(WideInt, AgreesWithGmpModulo2To256, ()) {
  agrees_with_gmp<256>();
}
RC_GTEST_PROP(WideInt, AgreesWithGmpModulo2To512, ()) {
  agrees_with_gmp<512>();
}

TEST(WideInt, IsExactUpToTheLastBit) {
  const WideInt<128> quarter = WideInt<128>(1) << 126;
  const WideInt<128> largest = (quarter - WideInt<128>(1)) + quarter;  // 2^127 − 1
  EXPECT_EQ(to_integer(largest), (Integer(1) << 127) - 1);
  EXPECT_EQ(largest.sign(), 1);
  EXPECT_EQ(to_integer(-largest - WideInt<128>(1)), -(Integer(1) << 127));
  EXPECT_LT(-largest, largest);
}

}  // namespace
}  // namespace ccdfuzz
