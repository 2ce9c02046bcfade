#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace ccdfuzz {

using Integer = mpz_class;
using Rational = mpq_class;

/// The exact value of a finite double. There is no way back that rounds silently.
Rational exact(double x);

/// The double equal to x, if there is one (the round trip of Section 5.4).
std::optional<double> to_double_exactly(const Rational& x);

/// The largest double ≤ x and the smallest double ≥ x; ±infinity past the ends of the range.
double round_down(const Rational& x);
double round_up(const Rational& x);

/// True iff the denominator is a power of two.
bool is_dyadic(const Rational& x);

/// 2^exponent, exactly.
Rational power_of_two(long exponent);

/// Canonical text: "p/q" in lowest terms with q > 1, or "p".
std::string to_text(const Rational& x);

/// The longest numerator or denominator that is read, in decimal digits; 16,610 bits. Doubles are
/// integers of at most 2,098 bits times 2^-1074. The largest numbers of a certificate are
/// coefficients that multiply four differences of two doubles: 8,400 bits. In proofs of 3,800
/// random linear queries of all magnitudes the largest has 5,732.
inline constexpr size_t kMaxRationalDigits = 5000;

/// Whether it is as short as that. Some numbers that are just as short are not known to be.
bool is_readable(const Rational& x);

/// Reads "p/q" or "p": decimal integers, optional leading minus, q > 0. The result is canonical.
/// Errors: anything else, naming the text; more digits than kMaxRationalDigits.
Result<Rational> parse_rational(std::string_view text);

/// Canonical hex-float text of a double, e.g. "0x1.8p-3"; for messages and for files.
std::string to_hex(double x);

}  // namespace ccdfuzz
