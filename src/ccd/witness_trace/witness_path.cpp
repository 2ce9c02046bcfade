#include "ccd/witness_trace/witness_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ccdfuzz {

// GMP's own functions on members: expressions would allocate for every trace.

WitnessPath::FixedPoint WitnessPath::fixed_point(const Integer& numerator,
                                                 const Integer& denominator) {
  mpz_mul_2exp(product_.get_mpz_t(), numerator.get_mpz_t(), Cell::kMaxDepth);
  mpz_fdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), product_.get_mpz_t(),
              denominator.get_mpz_t());
  return {quotient_.get_ui(), sgn(rest_) != 0};
}

TimeBounds WitnessPath::bounds_of(const Rational& t, int exponent) {
  if (sgn(t) == 0) return {0, 0};
  const auto bits = [](const Integer& x) {
    return static_cast<int>(mpz_sizeinbase(x.get_mpz_t(), 2));
  };
  // 2^(e-1) < t·2^-exponent < 2^(e+1): 53 or 54 bits before the point in these units, or fewer for
  // a subnormal.
  const int e = bits(t.get_num()) - bits(t.get_den()) - exponent;
  int unit = std::max(e - 53, -1074);
  product_ = t.get_num();
  denominator_ = t.get_den();
  const int down = unit + exponent;
  Integer& shifted = down < 0 ? product_ : denominator_;
  mpz_mul_2exp(shifted.get_mpz_t(), shifted.get_mpz_t(), static_cast<mp_bitcnt_t>(std::abs(down)));
  mpz_fdiv_qr(quotient_.get_mpz_t(), rest_.get_mpz_t(), product_.get_mpz_t(),
              denominator_.get_mpz_t());
  std::uint64_t units = quotient_.get_ui();
  bool more = sgn(rest_) != 0;
  if (units >> 53 != 0) {
    more |= (units & 1) != 0;
    units >>= 1;
    ++unit;
  }
  const double lo = std::ldexp(static_cast<double>(units), unit);
  return {lo, more ? std::nextafter(lo, std::numeric_limits<double>::infinity()) : lo};
}

void WitnessPath::assign(const std::array<Shape, 2>& shapes, const Witness& witness,
                         int time_exponent) {
  shapes_ = shapes;
  for (size_t side = 0; side < 2; ++side) {
    const Rational &u = witness.uv[side][0], &v = witness.uv[side][1];
    at_[side][0] = fixed_point(u.get_num(), u.get_den());
    at_[side][1] = fixed_point(v.get_num(), v.get_den());
    if (shapes[side].kind != ShapeKind::kTriangle) continue;
    mpz_mul(numerator_.get_mpz_t(), u.get_num_mpz_t(), v.get_den_mpz_t());
    mpz_addmul(numerator_.get_mpz_t(), v.get_num_mpz_t(), u.get_den_mpz_t());
    mpz_mul(denominator_.get_mpz_t(), u.get_den_mpz_t(), v.get_den_mpz_t());
    at_[side][2] = fixed_point(numerator_, denominator_);
  }
  time_ = bounds_of(witness.t, time_exponent);
}

bool WitnessPath::in(int side, const Cell& cell) const {
  const auto& [u, v, sum] = at_[static_cast<size_t>(side)];
  const int d = cell.depth;
  const ShapeKind kind = shapes_[static_cast<size_t>(side)].kind;
  if (kind == ShapeKind::kHull) refuse_hull();
  if (kind != ShapeKind::kTriangle) {
    return u.at_least(cell.i, d) && u.at_most(cell.i + 1, d) && v.at_least(cell.j, d) &&
           v.at_most(cell.j + 1, d);
  }
  const std::uint64_t diagonal = cell.i + cell.j + 1;
  return cell.inverted
             ? u.at_most(cell.i + 1, d) && v.at_most(cell.j + 1, d) && sum.at_least(diagonal, d)
             : u.at_least(cell.i, d) && v.at_least(cell.j, d) && sum.at_most(diagonal, d);
}

}  // namespace ccdfuzz
