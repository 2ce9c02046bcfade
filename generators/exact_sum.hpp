#pragma once

#include <cmath>

namespace ccdfuzz {

/// a += b. Returns false, with a rounded, if the sum is no double.
inline bool add_exactly(double& a, double b) {
  const double sum = a + b, part = sum - a;
  // What rounding took from either summand (Knuth's two-sum): exact unless the sum overflows.
  const double error = (a - (sum - part)) + (b - part);
  a = sum;
  return std::isfinite(sum) && error == 0;
}

}  // namespace ccdfuzz
