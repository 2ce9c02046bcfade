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

void Fraction::set_reduced(const Integer& common, Integer odd) {
  numerator_ = Dyadic(Integer(numerator_.mantissa() / common), numerator_.exponent());
  odd_ = odd == 1 ? std::nullopt : std::optional(std::move(odd));
}

Fraction& Fraction::operator+=(const Fraction& o) {
  if (!odd_ && !o.odd_) {
    numerator_ += o.numerator_;
    return *this;
  }
  // Each numerator has no divisor in common with its own. So the sum has none but what both share.
  const Integer shared = gcd(odd_divisor(), o.odd_divisor());
  const Dyadic own(Integer(odd_divisor() / shared), 0);
  const Dyadic other(Integer(o.odd_divisor() / shared), 0);
  const Integer& of_other = o.odd_divisor();
  numerator_ = numerator_ * other + o.numerator_ * own;
  const Integer common = gcd(numerator_.mantissa(), shared);
  set_reduced(common, own.mantissa() * of_other / common);
  return *this;
}

Fraction& Fraction::set_product(const Fraction& a, const Fraction& b) {
  if (!a.odd_ && !b.odd_) {
    numerator_.set_product(a.numerator_, b.numerator_);
    odd_.reset();
    return *this;
  }
  const Integer in_a = gcd(a.numerator_.mantissa(), b.odd_divisor());
  const Integer in_b = gcd(b.numerator_.mantissa(), a.odd_divisor());
  Integer odd = (a.odd_divisor() / in_b) * (b.odd_divisor() / in_a);
  numerator_.set_product(a.numerator_, b.numerator_);
  set_reduced(in_a * in_b, std::move(odd));
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
