#pragma once

#include "numeric/dyadic.hpp"

namespace ccdfuzz {

/// eps of Section 4.3 for doubles: 2^-52, twice the unit roundoff.
inline Dyadic section_4_3_epsilon() {
  return {Integer(1), -52};
}

/// B·[(1 + eps)^k − 1] of Theorem 4.1, exactly. k ≥ 0.
inline Dyadic theorem_4_1_bound(const Dyadic& magnitude, int roundings) {
  const Dyadic base = Dyadic(1) + section_4_3_epsilon();
  Dyadic power(1);
  for (int i = 0; i < roundings; ++i) power *= base;
  return magnitude * (power - Dyadic(1));
}

}  // namespace ccdfuzz
