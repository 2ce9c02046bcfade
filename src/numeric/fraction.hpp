#pragma once

#include <optional>

#include "numeric/dyadic.hpp"

namespace ccdfuzz {

/// The exact number n/d in lowest terms, n dyadic and d odd. Where d is 1, which it is of doubles,
/// sums and products take no gcd. So it is several times faster than the Rational that it equals.
class Fraction {
 public:
  Fraction() = default;
  Fraction(int x) : numerator_(x) {}                // NOLINT: as in any number type
  Fraction(Dyadic x) : numerator_(std::move(x)) {}  // NOLINT: exact
  Fraction(const Rational& x);                      // NOLINT: exact

  const Dyadic& numerator() const { return numerator_; }
  const Integer& odd_divisor() const;
  int sign() const { return numerator_.sign(); }
  Rational rational() const { return Rational(numerator_.rational() / odd_divisor()); }

  Fraction operator-() const { return *this * Fraction(-1); }
  Fraction& operator+=(const Fraction& o);
  /// Becomes a·b, in the memory that it has.
  Fraction& set_product(const Fraction& a, const Fraction& b);

  friend Fraction operator+(Fraction a, const Fraction& b) { return std::move(a += b); }
  friend Fraction operator-(Fraction a, const Fraction& b) { return std::move(a += -b); }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return std::move(Fraction().set_product(a, b));
  }
  /// Requires b ≠ 0.
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    return a * Fraction(Rational(1 / b.rational()));
  }
  friend bool operator==(const Fraction&, const Fraction&) = default;
  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return (a - b).sign() <=> 0;
  }

 private:
  /// The numerator over a common divisor of both, beside an odd divisor > 0 that is without it.
  void set_reduced(const Integer& common, Integer odd);

  Dyadic numerator_;
  std::optional<Integer> odd_;  ///< the divisor, if it is not 1
};

inline int sgn(const Fraction& x) {
  return x.sign();
}

/// The largest integer ≤ a/b. Requires b > 0.
Integer floor_of_ratio(const Fraction& a, const Fraction& b);

}  // namespace ccdfuzz
