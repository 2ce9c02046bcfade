#include "ccd/certified/time_polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ccd/certified/guess_root.hpp"

namespace ccdfuzz::certified {

namespace {

/// c: the coefficients in x, which is 0 at the begin of the part and 1 at its end, by powers.
/// Becomes those in Bernstein's basis, times binomials, which have the changes of sign; for power
/// x^j is x^j·(x + (1 − x))^(degree − j).
SignsOnPart signs_of(std::span<Int> c) {
  for (std::size_t last = c.size() - 1; last > 0; --last) {
    for (std::size_t j = 0; j < last; ++j) c[j + 1] += c[j];
  }
  SignsOnPart out;
  out.zero_at_lo = c.front().sign() == 0;
  out.zero_at_hi = c.back().sign() == 0;
  for (const Int& coefficient : c) {
    const int sign = coefficient.sign();
    if (sign == 0) continue;
    if (out.at_lo == 0) out.at_lo = sign;
    out.changes += out.at_hi == -sign;
    out.at_hi = sign;
  }
  return out;
}

}  // namespace

void TimePolynomial::trim(int degree) {
  degree_ = degree;
  while (degree_ >= 0 && (*this)[degree_].sign() == 0) --degree_;
}

TimePolynomial operator+(TimePolynomial a, const TimePolynomial& b) {
  for (std::size_t i = 0; static_cast<int>(i) <= b.degree_; ++i) a.c_[i] += b.c_[i];
  a.trim(std::max(a.degree_, b.degree_));
  return a;
}

TimePolynomial operator-(TimePolynomial a, const TimePolynomial& b) {
  for (std::size_t i = 0; static_cast<int>(i) <= b.degree_; ++i) a.c_[i] -= b.c_[i];
  a.trim(std::max(a.degree_, b.degree_));
  return a;
}

TimePolynomial operator*(const TimePolynomial& a, const TimePolynomial& b) {
  TimePolynomial r;
  if (a.is_zero() || b.is_zero()) return r;
  for (int i = 0; i <= a.degree_; ++i) {
    for (int j = 0; j <= b.degree_; ++j) r.c_[static_cast<std::size_t>(i + j)] += a[i] * b[j];
  }
  r.trim(a.degree_ + b.degree_);
  return r;
}

TimePolynomial TimePolynomial::derivative() const {
  TimePolynomial r;
  for (int i = 1; i <= degree_; ++i) r.c_[static_cast<std::size_t>(i - 1)] = (*this)[i] * i;
  r.trim(degree_ - 1);
  return r;
}

int TimePolynomial::sign_at(const TimeRatio& t) const {
  if (is_zero()) return 0;
  Int sum = (*this)[degree_], power(1);  // of the denominator: Horner's rule times its last power
  for (int i = degree_ - 1; i >= 0; --i) {
    power = power * t.den;
    sum = sum * t.num + (*this)[i] * power;
  }
  return sum.sign();
}

/// Coefficients of 2^(degree·level)·p in x, t = (m + x)·2^-level.
TimePolynomial::Coefficients TimePolynomial::on(const TimePart& part) const {
  Coefficients c;
  for (int i = 0; i <= degree_; ++i) {
    c[static_cast<std::size_t>(i)] = (*this)[i] << (degree_ - i) * part.level;
  }
  if (part.m.sign() == 0) return c;
  for (int i = 0; i < degree_; ++i) {
    for (auto j = static_cast<std::size_t>(degree_); j-- > static_cast<std::size_t>(i);) {
      c[j] += part.m * c[j + 1];
    }
  }
  return c;
}

SignsOnPart TimePolynomial::signs_on(const TimePart& part) const {
  if (is_zero()) return {};
  Coefficients c = on(part);
  return signs_of(std::span(c).first(static_cast<std::size_t>(degree_) + 1));
}

double TimePolynomial::guess_root(const TimePart& part) const {
  const Coefficients exact = on(part);
  std::array<Int::Approximation, 4> parts{};
  int top = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i] = exact[i].approximate();
    if (parts[i].mantissa != 0) top = std::max(top, parts[i].exponent);
  }
  std::array<double, 4> c{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    c[i] = std::ldexp(parts[i].mantissa, parts[i].exponent - top);
  }
  return certified::guess_root(c);
}

/// Each step takes the leading term away from lc(b)·p.
void TimePolynomial::reduce_by(const TimePolynomial& b) {
  while (degree_ >= b.degree_) {
    const Int& of_b = b[b.degree_];
    const Int of_this = (*this)[degree_];
    const int shift = degree_ - b.degree_;
    c_[static_cast<std::size_t>(degree_)] = {};
    for (int i = 0; i < degree_; ++i) {
      Int& c = c_[static_cast<std::size_t>(i)];
      c = c * of_b;
      if (i >= shift) c -= of_this * b[i - shift];
    }
    trim(degree_ - 1);
  }
}

TimePolynomial gcd(TimePolynomial a, TimePolynomial b) {
  while (b.degree() > 0) {
    a.reduce_by(b);
    std::swap(a, b);
  }
  return b.is_zero() ? a : b;
}

}  // namespace ccdfuzz::certified
