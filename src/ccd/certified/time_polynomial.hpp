#pragma once

#include <array>

#include "numeric/bounded_int.hpp"

namespace ccdfuzz::certified {

/// Coordinates are integers below 2^kMostBits where linear contacts are decided.
inline constexpr int kMostBits = 256;
// Law L6: all that is computed of them fits. The longest has 26·kMostBits + 60 bits: a cross at
// the root beside a repeated one (Law L4). A product takes a limb more than it may fill.
using Int = BoundedInt<26 * kMostBits + 128>;

/// From m·2^-level to (m + 1)·2^-level; the whole time step is [0, 1].
struct TimePart {
  Int m;
  int level = 0;
};

/// num/den, den > 0.
struct TimeRatio {
  Int num, den;
};

/// What the coefficients of a polynomial tell of a part of the time step.
struct SignsOnPart {
  bool zero_at_lo = true, zero_at_hi = true;
  int at_lo = 0, at_hi = 0;  ///< the sign just inside each end; 0 for the zero polynomial alone
  /// Descartes' bound (Law L3): the number of roots inside, with their multiplicities, is this or
  /// less by an even number. So 0 and 1 are what they say.
  int changes = 0;

  /// The number of roots inside is odd. Law L5 asks this of a divisor with one root at most.
  bool odd_roots() const { return at_lo != at_hi; }
};

/// A polynomial of time with integer coefficients, of degree 3 at most.
class TimePolynomial {
 public:
  TimePolynomial() = default;
  TimePolynomial(const Int& c0, const Int& c1) : c_{c0, c1} { trim(1); }

  /// −1 of the zero polynomial.
  int degree() const { return degree_; }
  bool is_zero() const { return degree_ < 0; }
  /// The coefficient of power i ≤ 3.
  const Int& operator[](int i) const { return c_[static_cast<std::size_t>(i)]; }

  friend TimePolynomial operator+(TimePolynomial a, const TimePolynomial& b);
  friend TimePolynomial operator-(TimePolynomial a, const TimePolynomial& b);
  /// Requires degrees that add up to 3 at most.
  friend TimePolynomial operator*(const TimePolynomial& a, const TimePolynomial& b);
  TimePolynomial derivative() const;

  /// The remainder by b up to a constant factor. Requires b ≠ 0.
  void reduce_by(const TimePolynomial& b);

  int sign_at(const TimeRatio& t) const;
  SignsOnPart signs_on(const TimePart& part) const;
  /// Where in the part, as a share of it, a root may be: a guess in doubles, in [0, 1). Requires
  /// that the signs at both ends differ.
  double guess_root(const TimePart& part) const;

 private:
  using Coefficients = std::array<Int, 4>;

  void trim(int degree);
  Coefficients on(const TimePart& part) const;

  Coefficients c_;
  int degree_ = -1;  ///< all coefficients above are 0
};

/// The greatest common divisor of two polynomials, not both 0, up to a constant factor. With the
/// derivative it has the repeated roots (Law L4), with another polynomial the common ones (Law L5).
TimePolynomial gcd(TimePolynomial a, TimePolynomial b);

}  // namespace ccdfuzz::certified
