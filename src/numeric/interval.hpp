#pragma once

#include <algorithm>
#include <cmath>
#include <iosfwd>
#include <limits>
#include <optional>

#include "numeric/rational.hpp"
#include "numeric/verify.hpp"

namespace ccdfuzz {

namespace interval_detail {

inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// The largest double ≤ exact, where exact = rounded + residual. A residual that is not a number
/// (after an overflow) counts as unknown.
inline double toward_minus(double rounded, double residual) {
  return residual >= 0 ? rounded : std::nextafter(rounded, -kInf);
}
inline double toward_plus(double rounded, double residual) {
  return residual <= 0 ? rounded : std::nextafter(rounded, kInf);
}

/// a + b − fl(a + b), exactly (Knuth); not a number where fl(a + b) overflows.
inline double sum_residual(double a, double b, double sum) {
  const double b_part = sum - a, a_part = sum - b_part;
  return (a - a_part) + (b - b_part);
}

/// a·b − fl(a·b), exactly; not a number where the residual may be smaller than the least double
/// (its exponent is up to 106 below that of the product), or the product overflows.
inline double product_residual(double a, double b, double product) {
  if (a == 0 || b == 0) return 0;
  constexpr double kResidualIsExact = 0x1p-960;  // > 2^(−1074 + 106)
  if (!(std::abs(product) >= kResidualIsExact)) return std::numeric_limits<double>::quiet_NaN();
  return std::fma(a, b, -product);
}

}  // namespace interval_detail

/// A closed interval of reals with double ends, rounded outward without touching the rounding mode:
/// each operation contains every exact result of members of its operands. Ends are as tight as
/// doubles allow, except where a product is smaller than 2^-960 (one ulp more on each side).
/// Ends may be infinite after an overflow, never both the same infinity.
class Interval {
 public:
  Interval() = default;
  /// The single number x, finite.
  explicit Interval(double x) : lo_(x), hi_(x) { CCDFUZZ_ASSERT(std::isfinite(x)); }
  /// Requires lo ≤ hi.
  Interval(double lo, double hi) : lo_(lo), hi_(hi) { CCDFUZZ_ASSERT(lo <= hi); }
  /// The tightest interval that contains x.
  static Interval enclosing(const Rational& x) { return {round_down(x), round_up(x)}; }

  double lo() const { return lo_; }
  double hi() const { return hi_; }
  bool contains(const Rational& x) const {
    return (lo_ == -interval_detail::kInf || exact(lo_) <= x) &&
           (hi_ == interval_detail::kInf || x <= exact(hi_));
  }
  /// The sign that every member has, if they all have the same.
  std::optional<int> sign() const {
    if (lo_ > 0) return 1;
    if (hi_ < 0) return -1;
    if (lo_ == 0 && hi_ == 0) return 0;
    return std::nullopt;
  }

  Interval operator-() const { return {-hi_, -lo_}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    using namespace interval_detail;
    const double lo = a.lo_ + b.lo_, hi = a.hi_ + b.hi_;
    return {toward_minus(lo, sum_residual(a.lo_, b.lo_, lo)),
            toward_plus(hi, sum_residual(a.hi_, b.hi_, hi))};
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    using namespace interval_detail;
    double lo = kInf, hi = -kInf;
    for (const double x : {a.lo_, a.hi_}) {
      for (const double y : {b.lo_, b.hi_}) {
        const double product = x == 0 || y == 0 ? 0 : x * y;  // 0·∞: every member's product is 0
        const double residual = product_residual(x, y, product);
        lo = std::min(lo, toward_minus(product, residual));
        hi = std::max(hi, toward_plus(product, residual));
      }
    }
    return {lo, hi};
  }

  friend bool operator==(const Interval&, const Interval&) = default;

 private:
  double lo_ = 0;
  double hi_ = 0;
};

/// The least interval that contains both.
inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lo(), b.lo()), std::max(a.hi(), b.hi())};
}

}  // namespace ccdfuzz
