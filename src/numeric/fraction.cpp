#include "numeric/fraction.hpp"

#include "base/verify.hpp"

namespace ccdfuzz {

Fraction::Fraction(const Rational& x) {
  const mp_bitcnt_t twos = mpz_scan1(x.get_den_mpz_t(), 0);
  numerator_ = Dyadic(x.get_num(), -static_cast<long>(twos));
  if (!is_dyadic(x)) odd_ = x.get_den() >> twos;
}

const Integer& Fraction::odd_divisor() const {
  static const Integer one = 1;
  return odd_ ? *odd_ : one;
}

void Fraction::set_divisor(Integer odd) {
  const Integer common = gcd(numerator_.mantissa(), odd);
  numerator_ = Dyadic(Integer(numerator_.mantissa() / common), numerator_.exponent());
  odd /= common;
  odd_ = odd == 1 ? std::nullopt : std::optional(std::move(odd));
}

Fraction& Fraction::operator+=(const Fraction& o) {
  if (!odd_ && !o.odd_) {
    numerator_ += o.numerator_;
    return *this;
  }
  const Dyadic own(odd_divisor(), 0), other(o.odd_divisor(), 0);
  numerator_ = numerator_ * other + o.numerator_ * own;
  set_divisor(odd_divisor() * o.odd_divisor());
  return *this;
}

Fraction& Fraction::set_product(const Fraction& a, const Fraction& b) {
  const bool is_dyadic = !a.odd_ && !b.odd_;
  numerator_.set_product(a.numerator_, b.numerator_);
  is_dyadic ? odd_.reset() : set_divisor(a.odd_divisor() * b.odd_divisor());
  return *this;
}

Integer floor_of_ratio(const Fraction& a, const Fraction& b) {
  CCDFUZZ_VERIFY(b.sign() > 0);
  Integer over = a.numerator().mantissa() * b.odd_divisor();
  Integer under = b.numerator().mantissa() * a.odd_divisor();
  const long shift = a.numerator().exponent() - b.numerator().exponent();
  (shift > 0 ? over : under) <<= static_cast<mp_bitcnt_t>(std::abs(shift));
  const mp_bitcnt_t twos = mpz_scan1(under.get_mpz_t(), 0);  // a shift is quicker than a quotient
  mpz_fdiv_q_2exp(over.get_mpz_t(), over.get_mpz_t(), twos);
  under >>= twos;
  if (under != 1) mpz_fdiv_q(over.get_mpz_t(), over.get_mpz_t(), under.get_mpz_t());
  return over;
}

}  // namespace ccdfuzz
