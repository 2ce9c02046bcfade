#pragma once

#include <vector>

#include "numeric/rational.hpp"

namespace ccdfuzz::linear {

/// A polynomial in one variable with integer coefficients, exact throughout.
/// Invariant: the leading coefficient is not zero; the zero polynomial has no coefficients.
class Polynomial {
 public:
  Polynomial() = default;
  /// coefficients[k] belongs to x^k.
  explicit Polynomial(std::vector<Integer> coefficients);

  bool is_zero() const { return coefficients_.empty(); }
  /// −1 for zero.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  /// The coefficient of x^k; requires 0 ≤ k ≤ degree().
  const Integer& operator[](int k) const { return coefficients_[static_cast<size_t>(k)]; }
  const Integer& leading() const { return coefficients_.back(); }
  const std::vector<Integer>& coefficients() const { return coefficients_; }

  /// The sign of the value at x.
  int sign_at(const Rational& x) const;

  Polynomial derivative() const;
  /// This over the greatest common divisor of its coefficients, which is positive.
  Polynomial primitive() const;

  Polynomial& operator+=(const Polynomial& o) { return combine(o, mpz_add); }
  Polynomial& operator-=(const Polynomial& o) { return combine(o, mpz_sub); }
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial&, const Polynomial&) = default;

 private:
  /// sum: mpz_add or mpz_sub.
  Polynomial& combine(const Polynomial& o, decltype(mpz_add)* sum);
  void trim();

  std::vector<Integer> coefficients_;
};

/// The signs of a polynomial on an interval: its Bernstein coefficients there, each times its
/// binomial coefficient and all times one positive number.
class PolynomialPart {
 public:
  PolynomialPart() = default;
  /// On [lo, hi]. Requires p ≠ 0, lo < hi.
  PolynomialPart(const Polynomial& p, const Rational& lo, const Rational& hi);

  int sign_at_lo() const { return sgn(coefficients_.front()); }
  int sign_at_hi() const { return sgn(coefficients_.back()); }
  /// Changes of sign: as many as roots in the open interval, each as often as it is one, or an even
  /// number more.
  int changes() const;
  /// True iff it has no root in the closed interval by its changes.
  bool has_one_sign() const { return sign_at_lo() * sign_at_hi() > 0 && changes() == 0; }

  /// The same on the lower or the upper half of the interval.
  PolynomialPart half(bool upper) const;

 private:
  std::vector<Integer> coefficients_;
};

/// The greatest common divisor over the rationals, primitive; of zero and a, a.
Polynomial gcd(Polynomial a, Polynomial b);

/// The polynomial with the same roots, each once. Requires p ≠ 0.
Polynomial squarefree(const Polynomial& p);

}  // namespace ccdfuzz::linear
