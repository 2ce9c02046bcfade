#pragma once

#include <cmath>

namespace ccdfuzz {

/// The float that is nearest to x, as a double; infinite where it is past the largest float.
/// It is never inlined: GCC 12 leaves out both conversions where it makes two of them one of
/// vectors, as in a loop over coordinates.
[[gnu::noinline]] inline double nearest_float(double x) {
  return static_cast<double>(static_cast<float>(x));
}

/// Whether x is a finite float.
inline bool is_float(double x) {
  return std::isfinite(x) && nearest_float(x) == x;
}

}  // namespace ccdfuzz
