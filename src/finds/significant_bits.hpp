#pragma once

#include <cmath>

namespace ccdfuzz {

/// x with at most `bits` significant bits; 0 with none. to_whole rounds to a whole number:
/// std::trunc towards 0, std::round to the nearest.
inline double with_bits(double x, int bits, double (*to_whole)(double)) {
  if (bits == 0 || x == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(to_whole(std::ldexp(fraction, bits)), exponent - bits);
}

}  // namespace ccdfuzz
