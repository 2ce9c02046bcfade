#include "certify/linear/real_root.hpp"

#include <algorithm>

#include "base/verify.hpp"

namespace ccdfuzz::linear {

namespace {

/// The root of a polynomial of degree 1.
Rational linear_root(const Polynomial& p) {
  return Rational(-p[0]) / p[1];
}

/// Those in the open (lo, hi), in their order. p squarefree, `part` on [lo, hi]. By Descartes' rule
/// of signs there is none without a change of signs, and one with one change. Short intervals have
/// no more, as p is squarefree.
void isolate(const Polynomial& p, const PolynomialPart& part, const Rational& lo,
             const Rational& hi, std::vector<RealRoot>& out) {
  const int changes = part.changes();
  if (changes == 0) return;
  if (changes == 1 && p.degree() == 1) return out.push_back(RealRoot(linear_root(p)));
  if (changes == 1 && part.sign_at_lo() * part.sign_at_hi() < 0) {
    return out.push_back(RealRoot(p, part, lo, hi));
  }
  const Rational middle = (lo + hi) / 2;
  const PolynomialPart upper = part.half(true);
  isolate(p, part.half(false), lo, middle, out);
  if (upper.sign_at_lo() == 0) out.emplace_back(middle);
  isolate(p, upper, middle, hi, out);
}

}  // namespace

RealRoot::RealRoot(Polynomial p, PolynomialPart part, Rational lo, Rational hi)
    : p_(std::move(p)), part_(std::move(part)), lo_(std::move(lo)), hi_(std::move(hi)) {
  CCDFUZZ_ASSERT(part_.sign_at_lo() * part_.sign_at_hi() < 0);
}

Polynomial RealRoot::polynomial() const {
  return is_rational() ? Polynomial({-lo_.get_num(), lo_.get_den()}) : p_;
}

void RealRoot::refine() {
  if (is_rational()) return;
  Rational middle = (lo_ + hi_) / 2;
  PolynomialPart upper = part_.half(true);
  if (upper.sign_at_lo() == 0) {
    lo_ = hi_ = std::move(middle);
  } else if (upper.sign_at_lo() == part_.sign_at_lo()) {
    part_ = std::move(upper);
    lo_ = std::move(middle);
  } else {
    part_ = part_.half(false);
    hi_ = std::move(middle);
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
  PolynomialPart part(q, lo_, hi_);
  // A common divisor has at most the root of p_ here, and that once.
  bool compared = false;
  while (!is_rational() && !part.has_one_sign()) {
    if (!compared) {
      compared = true;
      const Polynomial common = gcd(p_, q);
      if (common.sign_at(lo_) * common.sign_at(hi_) < 0) {
        p_ = common;
        part_ = PolynomialPart(p_, lo_, hi_);
        if (p_.degree() == 1) lo_ = hi_ = linear_root(p_);
        return 0;
      }
    }
    const Rational hi = hi_;
    refine();
    part = part.half(hi_ == hi);
  }
  return is_rational() ? q.sign_at(lo_) : part.sign_at_lo();
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
  const auto take = [&p](const Rational& end) { return p.sign_at(end) == 0; };
  if (take(from)) roots.emplace_back(from);
  if (from == to) return roots;
  const Polynomial simple = squarefree(p);
  const PolynomialPart part(simple, from, to);
  isolate(simple, part, from, to, roots);
  if (take(to)) roots.emplace_back(to);
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
