#pragma once

#include <cmath>

#include "numeric/dyadic.hpp"

namespace ccdfuzz {

/// a += b. Returns false, with a rounded, if the sum is no double.
inline bool add_exactly(double& a, double b) {
  const double sum = a + b, part = sum - a;
  // What rounding took from either summand (Knuth's two-sum): exact unless the sum overflows.
  const double error = (a - (sum - part)) + (b - part);
  a = sum;
  return std::isfinite(sum) && error == 0;
}

/// The exponent e with |x| < 2^e ≤ 2|x|; x ≠ 0.
inline long top_of(const Dyadic& x) {
  return x.exponent() + static_cast<long>(mpz_sizeinbase(x.mantissa().get_mpz_t(), 2));
}

}  // namespace ccdfuzz
