#include "certify/linear/polynomial.hpp"

#include <algorithm>

#include "base/time_limit.hpp"
#include "base/verify.hpp"

namespace ccdfuzz::linear {

Polynomial::Polynomial(std::vector<Integer> coefficients) : coefficients_(std::move(coefficients)) {
  trim();
}

void Polynomial::trim() {
  while (!coefficients_.empty() && coefficients_.back() == 0) coefficients_.pop_back();
}

int Polynomial::sign_at(const Rational& x) const {
  // d^degree · p(n/d) by Horner's rule in integers: no gcd is taken.
  const Integer &n = x.get_num(), &d = x.get_den();
  Integer sum = 0, power = 1;
  for (int k = degree(); k >= 0; --k) {
    sum = sum * n + (*this)[k] * power;
    power *= d;
  }
  return sgn(sum);
}

Polynomial Polynomial::derivative() const {
  std::vector<Integer> d;
  for (int k = 1; k <= degree(); ++k) d.push_back((*this)[k] * k);
  return Polynomial(std::move(d));
}

Polynomial Polynomial::primitive() const {
  Integer content = 0;
  for (const Integer& c : coefficients_) content = gcd(content, c);
  if (content <= 1) return *this;
  Polynomial p = *this;
  for (Integer& c : p.coefficients_)
    mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
  return p;
}

Polynomial& Polynomial::combine(const Polynomial& o, decltype(mpz_add)* sum) {
  coefficients_.resize(std::max(coefficients_.size(), o.coefficients_.size()));
  for (size_t k = 0; k < o.coefficients_.size(); ++k) {
    mpz_ptr c = coefficients_[k].get_mpz_t();
    sum(c, c, o.coefficients_[k].get_mpz_t());
  }
  trim();
  return *this;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.is_zero() || b.is_zero()) return {};
  TimeLimit::stop_if_late();
  std::vector<Integer> product(a.coefficients_.size() + b.coefficients_.size() - 1);
  for (size_t i = 0; i < a.coefficients_.size(); ++i) {
    for (size_t j = 0; j < b.coefficients_.size(); ++j) {
      product[i + j] += a.coefficients_[i] * b.coefficients_[j];
    }
  }
  return Polynomial(std::move(product));
}

PolynomialPart::PolynomialPart(const Polynomial& p, const Rational& lo, const Rational& hi) {
  // With lo = a/d, hi = b/d it is Σ p_k·(a + b·z)^k·(d + d·z)^(n − k), by Horner's rule.
  const Integer d = lcm(lo.get_den(), hi.get_den());
  const Polynomial ends(
      {Integer(d / lo.get_den() * lo.get_num()), Integer(d / hi.get_den() * hi.get_num())});
  const Polynomial whole({d, d});
  Polynomial sum, power({Integer(1)});
  for (int k = p.degree(); k >= 0; --k) {
    sum = sum * ends + Polynomial({p[k]}) * power;
    power = power * whole;
  }
  coefficients_ = sum.primitive().coefficients();
  coefficients_.resize(static_cast<size_t>(p.degree()) + 1);
}

int PolynomialPart::changes() const {
  int changes = 0, last = 0;
  for (const Integer& c : coefficients_) {
    if (last * sgn(c) < 0) ++changes;
    if (c != 0) last = sgn(c);
  }
  return changes;
}

PolynomialPart PolynomialPart::half(bool upper) const {
  TimeLimit::stop_if_late();
  // Σ c_k·x^(n − k)·y^k is on the lower half that of 2x + y and y, on the upper that of x, x + 2y.
  PolynomialPart out = *this;
  std::vector<Integer>& c = out.coefficients_;
  if (!upper) std::ranges::reverse(c);
  for (size_t from = 1; from < c.size(); ++from) {
    for (size_t k = c.size() - 1; k >= from; --k) c[k - 1] += c[k];
  }
  for (size_t k = 0; k < c.size(); ++k) c[k] <<= k;
  if (!upper) std::ranges::reverse(c);
  return out;
}

namespace {

/// |c|·a − sign(c)·(leading coefficient of a)·x^shift·b, c that of b: one step of a division,
/// which takes the leading term away.
Polynomial reduced(const Polynomial& a, const Polynomial& b) {
  TimeLimit::stop_if_late();
  std::vector<Integer> r = a.coefficients();
  const Integer scale = abs(b.leading());
  const Integer factor = sgn(b.leading()) * a.leading();
  const int shift = a.degree() - b.degree();
  for (Integer& c : r) c *= scale;
  for (int k = 0; k <= b.degree(); ++k) r[static_cast<size_t>(k + shift)] -= factor * b[k];
  return Polynomial(std::move(r));
}

/// A multiple of a / b, primitive. Requires b ≠ 0 that divides a over the rationals.
Polynomial quotient(Polynomial a, const Polynomial& b) {
  std::vector<Integer> q(static_cast<size_t>(std::max(a.degree() - b.degree() + 1, 0)));
  const Integer scale = abs(b.leading());
  while (!a.is_zero()) {
    CCDFUZZ_VERIFY(a.degree() >= b.degree());
    for (Integer& c : q) c *= scale;
    q[static_cast<size_t>(a.degree() - b.degree())] += sgn(b.leading()) * a.leading();
    a = reduced(a, b);
  }
  return Polynomial(std::move(q)).primitive();
}

}  // namespace

Polynomial gcd(Polynomial a, Polynomial b) {
  while (!b.is_zero()) {
    while (a.degree() >= b.degree()) a = reduced(a, b);
    a = a.primitive();
    std::swap(a, b);
  }
  return a.primitive();
}

Polynomial squarefree(const Polynomial& p) {
  const Polynomial repeated = gcd(p, p.derivative());
  return repeated.degree() == 0 ? p.primitive() : quotient(p, repeated);
}

}  // namespace ccdfuzz::linear
