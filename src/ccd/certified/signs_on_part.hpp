#pragma once

#include <cstddef>
#include <span>

namespace ccdfuzz::certified {

/// What the coefficients of a polynomial tell of a part of the time step.
struct SignsOnPart {
  bool zero_at_lo = true, zero_at_hi = true;
  int at_lo = 0, at_hi = 0;  ///< the sign just inside each end; 0 for the zero polynomial alone
  /// Descartes' bound (Law L3): the number of roots inside, with their multiplicities, is this or
  /// less by an even number. So 0 and 1 are what they say.
  int changes = 0;

  /// The number of roots inside is odd. Law L5 asks this of a divisor with one root at most.
  bool odd_roots() const { return at_lo != at_hi; }
};

/// c: the coefficients in x, which is 0 at the begin of the part and 1 at its end, by powers.
/// Becomes those in Bernstein's basis, times binomials, which have the changes of sign; for power
/// x^j is x^j·(x + (1 − x))^(degree − j).
template <class Int>
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

}  // namespace ccdfuzz::certified
