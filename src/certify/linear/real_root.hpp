#pragma once

#include <compare>
#include <vector>

#include "certify/linear/polynomial.hpp"

namespace ccdfuzz::linear {

/// A real algebraic number, exactly: the only root of a squarefree polynomial in the open
/// (lo, hi), neither end being a root; or the rational lo = hi.
class RealRoot {
 public:
  explicit RealRoot(Rational x) : lo_(x), hi_(std::move(x)) {}
  /// Requires: p is squarefree, has one root in (lo, hi), and none at the ends. part: p on [lo,
  /// hi].
  RealRoot(Polynomial p, PolynomialPart part, Rational lo, Rational hi);

  /// The enclosure so far.
  const Rational& lo() const { return lo_; }
  const Rational& hi() const { return hi_; }
  bool is_rational() const { return lo_ == hi_; }  ///< known to be
  /// The polynomial; for a rational number its linear one.
  Polynomial polynomial() const;

  /// Halves the enclosure.
  void refine();
  /// Refines until hi − lo ≤ width, then looks for the simplest rational number in the enclosure.
  /// If that is the root, it is found to be rational.
  void narrow(const Rational& width);

  /// The sign of q at the number; refines where it must. Where it is 0, polynomial() divides q
  /// afterwards. Else the closed enclosure has no root of q afterwards.
  int sign_of(const Polynomial& q);

  /// True iff both are the same number.
  bool equals(const RealRoot& o) const;

 private:
  Polynomial p_;
  PolynomialPart part_;  ///< unless it is rational
  Rational lo_, hi_;
};

/// Refines both until it is clear which is less, unless they are equal.
std::strong_ordering compare(RealRoot& a, RealRoot& b);

/// The roots of p in the closed [from, to], ascending. Requires p ≠ 0, from ≤ to.
/// By bisection, counting with Descartes' rule of signs.
std::vector<RealRoot> roots_in(const Polynomial& p, const Rational& from, const Rational& to);

/// The fraction with the least denominator in the open (lo, hi); of those the one nearest to 0.
/// Requires 0 ≤ lo < hi.
Rational simplest_between(const Rational& lo, const Rational& hi);

}  // namespace ccdfuzz::linear
