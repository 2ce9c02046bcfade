#include "numeric/rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_parts.hpp"
#include "base/fp_guard.hpp"
#include "base/verify.hpp"
#include "numeric/next_double.hpp"

namespace ccdfuzz {

namespace {

/// x·2^exponent; without the common divisors that a product would look for.
Rational scaled(Rational x, long exponent) {
  if (exponent >= 0) {
    mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return x;
}

/// x rounded towards 0; the largest double past the range. By bits and integers alone.
double truncated(const Rational& x) {
  const double d = x.get_d();
  return std::copysign(is_finite(d) ? d : std::numeric_limits<double>::max(), sgn(x));
}

}  // namespace

Rational exact(double x) {
  CCDFUZZ_VERIFY(is_finite(x));
  const DoubleParts parts = parts_of(x);
  return scaled(static_cast<long>(parts.mantissa), parts.exponent);
}

Rational power_of_two(long exponent) {
  return scaled(1, exponent);
}

double round_down(const Rational& x) {
  const double d = truncated(x);
  return exact(d) > x ? next_down(d) : d;
}

double round_up(const Rational& x) {
  const double d = truncated(x);
  return exact(d) < x ? next_up(d) : d;
}

std::optional<double> to_double_exactly(const Rational& x) {
  const double d = truncated(x);
  return exact(d) == x ? std::optional(d) : std::nullopt;
}

bool is_dyadic(const Rational& x) {
  return mpz_popcount(x.get_den_mpz_t()) == 1;
}

std::string to_text(const Rational& x) {
  return x.get_str();
}

bool is_readable(const Rational& x) {
  return mpz_sizeinbase(x.get_num_mpz_t(), 10) <= kMaxRationalDigits &&
         mpz_sizeinbase(x.get_den_mpz_t(), 10) <= kMaxRationalDigits;
}

Result<Rational> parse_rational(std::string_view text) {
  const auto refuse = [&] {
    constexpr size_t kShown = 60;
    return input_error("", "\"{}{}\" is not a rational \"p\" or \"p/q\" with q > 0",
                       text.substr(0, kShown), text.size() > kShown ? "…" : "");
  };
  const auto digits = [](std::string_view s) {
    return !s.empty() &&
           std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  const size_t slash = text.find('/');
  std::string_view p = text.substr(0, slash);
  if (!p.empty() && p.front() == '-') p.remove_prefix(1);
  const std::string_view q = slash == std::string_view::npos ? "1" : text.substr(slash + 1);
  if (!digits(p) || !digits(q)) return refuse();
  if (const size_t longer = std::max(p.size(), q.size()); longer > kMaxRationalDigits) {
    return input_error("",
                       "has a numerator or denominator of {} digits; at most {} "
                       "are read",
                       longer, kMaxRationalDigits);
  }
  Rational r;
  if (r.set_str(std::string(text), 10) != 0 || sgn(r.get_den()) == 0) return refuse();
  r.canonicalize();
  return r;
}

std::string to_hex(double x) {
  const FpGuard guard;
  return fmt::format("{:a}", x);
}

}  // namespace ccdfuzz
