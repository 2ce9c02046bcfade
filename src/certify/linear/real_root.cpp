#include "certify/linear/real_root.hpp"

#include <algorithm>

#include "base/verify.hpp"

namespace ccdfuzz::linear {

namespace {

/// Sturm's sequence of p ≠ 0: counts the distinct real roots of p.
class SturmSequence {
 public:
  explicit SturmSequence(const Polynomial& p) : sequence_{p.primitive()} {
    for (Polynomial next = p.derivative().primitive(); !next.is_zero();) {
      sequence_.push_back(std::move(next));
      const size_t n = sequence_.size();
      next = Polynomial() - remainder(sequence_[n - 2], sequence_[n - 1]);
    }
  }

  /// Sign changes at x, zeros left out.
  int changes_at(const Rational& x) const {
    int changes = 0, last = 0;
    for (const Polynomial& p : sequence_) {
      const int sign = p.sign_at(x);
      if (sign == 0) continue;
      if (last == -sign) ++changes;
      last = sign;
    }
    return changes;
  }

  /// Distinct roots in the half-open (lo, hi].
  int roots_in(const Rational& lo, const Rational& hi) const {
    return changes_at(lo) - changes_at(hi);
  }

 private:
  std::vector<Polynomial> sequence_;
};

Rational middle_of(const Rational& lo, const Rational& hi) {
  return (lo + hi) / 2;
}

/// The root of a polynomial of degree 1.
Rational linear_root(const Polynomial& p) {
  Rational root(-p[0], p[1]);
  root.canonicalize();
  return root;
}

/// p squarefree, no root at the ends.
void isolate(const Polynomial& p, const SturmSequence& sturm, const Rational& lo,
             const Rational& hi, std::vector<RealRoot>& out) {
  const int count = sturm.roots_in(lo, hi);
  if (count == 0) return;
  if (count == 1) {
    out.push_back(p.degree() == 1 ? RealRoot(linear_root(p)) : RealRoot(p, lo, hi));
    return;
  }
  // One of any degree + 1 points is no root.
  Rational middle = middle_of(lo, hi);
  while (p.sign_at(middle) == 0) middle = middle_of(lo, middle);
  isolate(p, sturm, lo, middle, out);
  isolate(p, sturm, middle, hi, out);
}

}  // namespace

RealRoot::RealRoot(Polynomial p, Rational lo, Rational hi)
    : p_(std::move(p)), lo_(std::move(lo)), hi_(std::move(hi)), sign_at_lo_(p_.sign_at(lo_)) {
  CCDFUZZ_ASSERT(sign_at_lo_ * p_.sign_at(hi_) < 0);
}

Polynomial RealRoot::polynomial() const {
  return is_rational() ? Polynomial({-lo_.get_num(), lo_.get_den()}) : p_;
}

void RealRoot::refine() {
  if (is_rational()) return;
  Rational middle = middle_of(lo_, hi_);
  const int sign = p_.sign_at(middle);
  if (sign == 0) {
    lo_ = hi_ = std::move(middle);
  } else {
    (sign == sign_at_lo_ ? lo_ : hi_) = std::move(middle);
  }
}

void RealRoot::narrow(const Rational& width) {
  while (hi_ - lo_ > width) refine();
  if (is_rational() || lo_ < 0) return;
  const Rational simplest = simplest_between(lo_, hi_);
  if (p_.sign_at(simplest) == 0) lo_ = hi_ = simplest;
}

int RealRoot::sign_of(const Polynomial& q) {
  if (q.degree() <= 0) return q.is_zero() ? 0 : sgn(q.leading());
  if (is_rational()) return q.sign_at(lo_);
  const SturmSequence sturm(q);
  // A common divisor has at most the root of p_ here, and that once.
  bool compared = false;
  while (!is_rational() && (sturm.roots_in(lo_, hi_) > 0 || q.sign_at(lo_) == 0)) {
    if (!compared) {
      compared = true;
      const Polynomial common = gcd(p_, q);
      if (common.sign_at(lo_) * common.sign_at(hi_) < 0) {
        p_ = common;
        sign_at_lo_ = p_.sign_at(lo_);
        if (p_.degree() == 1) lo_ = hi_ = linear_root(p_);
        return 0;
      }
    }
    refine();
  }
  return q.sign_at(lo_);
}

bool RealRoot::equals(const RealRoot& o) const {
  if (is_rational() && o.is_rational()) return lo_ == o.lo_;
  if (is_rational()) return o.equals(*this);
  if (o.is_rational()) return lo_ < o.lo_ && o.lo_ < hi_ && p_.sign_at(o.lo_) == 0;
  // A common root in both enclosures is both numbers. No end is a root.
  const Rational &lo = std::max(lo_, o.lo_), &hi = std::min(hi_, o.hi_);
  const Polynomial common = gcd(p_, o.p_);
  return lo < hi && common.sign_at(lo) * common.sign_at(hi) < 0;
}

std::strong_ordering compare(RealRoot& a, RealRoot& b) {
  if (a.equals(b)) return std::strong_ordering::equal;
  while (true) {
    if (a.hi() <= b.lo()) return std::strong_ordering::less;
    if (b.hi() <= a.lo()) return std::strong_ordering::greater;
    a.refine();
    b.refine();
  }
}

std::vector<RealRoot> roots_in(const Polynomial& p, const Rational& from, const Rational& to) {
  std::vector<RealRoot> roots;
  Polynomial rest = squarefree(p);
  const auto take = [&rest](const Rational& x) {
    if (rest.sign_at(x) != 0) return false;
    rest = quotient(rest, Polynomial({-x.get_num(), x.get_den()}));
    return true;
  };
  if (take(from)) roots.emplace_back(from);
  if (from == to) return roots;
  const bool at_end = take(to);
  if (rest.degree() > 0) isolate(rest, SturmSequence(rest), from, to, roots);
  if (at_end) roots.emplace_back(to);
  return roots;
}

Rational simplest_between(const Rational& lo, const Rational& hi) {
  // x = whole + 1/y: the simplest x has the simplest y.
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), lo.get_num_mpz_t(), lo.get_den_mpz_t());
  const Rational base(whole), next(whole + 1);
  if (next < hi) return next;
  const Rational low = lo - base, high = hi - base;  // 0 ≤ low < high ≤ 1
  if (low == 0) {
    Integer y;
    mpz_fdiv_q(y.get_mpz_t(), high.get_den_mpz_t(), high.get_num_mpz_t());
    return base + 1 / Rational(y + 1);
  }
  const Rational inverse = simplest_between(1 / high, 1 / low);
  return base + 1 / inverse;
}

}  // namespace ccdfuzz::linear
