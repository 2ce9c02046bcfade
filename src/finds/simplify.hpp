#pragma once

#include <cmath>
#include <compare>
#include <functional>

#include "finds/content_address.hpp"
#include "generators/contact.hpp"

namespace ccdfuzz {

/// How simple a query and its contact are, simplest first. It begins with CaseSize, by which a
/// store compares.
struct Simplicity {
  CaseSize size;
  std::uint64_t witness_bits = 0;      ///< in t and uv
  std::uint64_t different_points = 0;  ///< control points that differ in position or velocity
  std::uint64_t exponents = 0;         ///< sum of |exponent| of all coordinates
  friend auto operator<=>(const Simplicity&, const Simplicity&) = default;
};

Simplicity simplicity_of(const Contact& q);

/// Offers simpler forms of a query, the boldest first; the contact may be broken in them. `offer`
/// returns whether the form was taken: then the next ones start from what the reference holds.
/// One round through all kinds of simplification; a second one may do more.
void offer_simpler(const Contact& current, const std::function<bool(const Contact&)>& offer);

/// x with at most `bits` significant bits; 0 with none. to_whole rounds to a whole number:
/// std::trunc towards 0, std::round to the nearest.
inline double with_bits(double x, int bits, double (*to_whole)(double)) {
  if (bits == 0 || x == 0) return 0;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(to_whole(std::ldexp(fraction, bits)), exponent - bits);
}

}  // namespace ccdfuzz
