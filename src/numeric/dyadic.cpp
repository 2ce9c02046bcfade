#include "numeric/dyadic.hpp"

#include <ostream>

#include "base/double_parts.hpp"
#include "base/verify.hpp"

namespace ccdfuzz {

void Dyadic::normalise() {
  if (m_ == 0) {
    k_ = 0;
    return;
  }
  const mp_bitcnt_t zeros = mpz_scan1(m_.get_mpz_t(), 0);
  if (zeros == 0) return;
  mpz_tdiv_q_2exp(m_.get_mpz_t(), m_.get_mpz_t(), zeros);
  k_ += static_cast<long>(zeros);
}

Dyadic Dyadic::exact(double x) {
  CCDFUZZ_VERIFY(is_finite(x));
  const DoubleParts parts = parts_of(x);
  return {Integer(static_cast<long>(parts.mantissa)), parts.exponent};
}

std::optional<Dyadic> Dyadic::from(const Rational& x) {
  if (!is_dyadic(x)) return std::nullopt;
  return Dyadic(x.get_num(), -static_cast<long>(mpz_scan1(x.get_den_mpz_t(), 0)));
}

Rational Dyadic::rational() const {
  return Rational(m_) * power_of_two(k_);
}

std::optional<double> Dyadic::to_double_exactly() const {
  const long bits = m_ == 0 ? 0 : static_cast<long>(mpz_sizeinbase(m_.get_mpz_t(), 2));
  if (bits > 53 || k_ < -1074 || k_ + bits > 1024) return std::nullopt;
  return double_of(m_.get_si(), static_cast<int>(k_));
}

Dyadic& Dyadic::combine(const Dyadic& o, decltype(mpz_add)* sum) {
  if (o.m_ == 0) return *this;
  if (m_ == 0) k_ = o.k_;
  if (k_ < o.k_) {
    thread_local Integer shifted;  // keeps its memory
    mpz_mul_2exp(shifted.get_mpz_t(), o.m_.get_mpz_t(), static_cast<mp_bitcnt_t>(o.k_ - k_));
    sum(m_.get_mpz_t(), m_.get_mpz_t(), shifted.get_mpz_t());
  } else {
    mpz_mul_2exp(m_.get_mpz_t(), m_.get_mpz_t(), static_cast<mp_bitcnt_t>(k_ - o.k_));
    k_ = o.k_;
    sum(m_.get_mpz_t(), m_.get_mpz_t(), o.m_.get_mpz_t());
  }
  normalise();
  return *this;
}

Dyadic& Dyadic::set_product(const Dyadic& a, const Dyadic& b) {
  m_ = a.m_ * b.m_;
  k_ = m_ == 0 ? 0 : a.k_ + b.k_;  // odd times odd is odd
  return *this;
}

std::ostream& operator<<(std::ostream& out, const Dyadic& x) {
  return out << x.m_.get_str() << "*2^" << x.k_;
}

}  // namespace ccdfuzz
