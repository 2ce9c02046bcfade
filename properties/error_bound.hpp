#pragma once

#include "numeric/dyadic.hpp"
#include "numeric/exact_scalars.hpp"

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

/// u and η: half an ulp of 1, and the least double above 0.
inline Dyadic half_ulp() {
  return {Integer(1), -53};
}
inline Dyadic least_double() {
  return {Integer(1), -1074};
}

/// ≥ (1 + u)^k − 1, since (1 + u)^k − 1 ≤ ku(1 + ku) where ku < 1.
inline Dyadic within_roundings(int k) {
  const Dyadic ku = Dyadic(k) * half_ulp();
  return ku * (Dyadic(1) + ku);
}

/// What src/ccd/certified/DERIVATION.md, 3, adds up to E of tdibm-c: u·(D·d + 8)·M·|l|₁ with all
/// higher powers of u, four times `absolute` and 2048·η times |l|₁, and 16·η. roundings: D·d; norm:
/// |l|₁.
inline Dyadic derived_error(double magnitude, double absolute, int roundings, const Dyadic& norm) {
  const Dyadic per_norm = within_roundings(roundings + 8) * Dyadic::exact(magnitude) +
                          Dyadic::exact(absolute).scaled(2) + least_double().scaled(11);
  return per_norm * norm + least_double().scaled(4);
}

}  // namespace ccdfuzz
