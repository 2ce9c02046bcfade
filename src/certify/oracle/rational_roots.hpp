#pragma once

#include <optional>

#include "numeric/rational.hpp"

namespace ccdfuzz {

/// How near to each other, relative to the time, clear_until and the witness of bodies are to be.
inline constexpr int kBracketBits = 40;
/// Times that are no contact are rounded down to about so many bits, lest they grow.
inline constexpr int kTimeBits = 96;

inline size_t bits_of(const Integer& x) {
  return mpz_sizeinbase(x.get_mpz_t(), 2);
}

/// The root of x, if it is rational.
inline std::optional<Rational> rational_root(const Rational& x) {
  const Integer &p = x.get_num(), &q = x.get_den();
  const bool is_square =
      mpz_perfect_square_p(p.get_mpz_t()) != 0 && mpz_perfect_square_p(q.get_mpz_t()) != 0;
  return is_square ? std::optional(Rational(sqrt(p), sqrt(q))) : std::nullopt;
}

/// The root of x ≥ 0, rounded up by at most 2^-kTimeBits of it; exact where it is rational.
inline Rational root_above(const Rational& x) {
  if (const auto root = rational_root(x)) return *root;
  const Integer &p = x.get_num(), &q = x.get_den();
  // √(p/q) = √(pq)/q = √(pq·4^k) / (q·2^k)
  const Integer product = p * q;
  const size_t has = bits_of(product) / 2;
  const size_t k = has < kTimeBits + 1 ? kTimeBits + 1 - has : 0;
  return Rational(sqrt(Integer(product << (2 * k))) + 1) / Integer(q << k);
}

/// x rounded down to a multiple of the unit.
inline Rational rounded_down(const Rational& x, const Rational& unit) {
  const Rational scaled = x / unit;
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) * unit;
}

/// A power of two at most x > 0, and more than x/4.
inline Rational power_below(const Rational& x) {
  const auto top =
      static_cast<long>(bits_of(x.get_num())) - static_cast<long>(bits_of(x.get_den()));
  return power_of_two(top - 1);
}

}  // namespace ccdfuzz
