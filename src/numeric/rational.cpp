#include "numeric/rational.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/double_parts.hpp"
#include "base/fp_guard.hpp"
#include "base/verify.hpp"

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

constexpr int kMantissaBits = std::numeric_limits<double>::digits;                        // 53
constexpr long kMinExponent = std::numeric_limits<double>::min_exponent - kMantissaBits;  // -1074
constexpr int kMaxExponent = std::numeric_limits<double>::max_exponent - kMantissaBits;   // 971

/// Exponent e with 2^(e-1) ≤ |x| < 2^(e+1) for x ≠ 0: off by at most one from the true one.
long rough_exponent(const Rational& x) {
  return static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2)) -
         static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

/// The largest double ≤ x is mantissa·2^exponent, and the next one is one unit of 2^exponent more.
struct Truncated {
  std::int64_t mantissa;
  int exponent;
  bool is_exact;  ///< it equals x

  double down() const { return double_of(mantissa, exponent); }
  double up() const { return double_of(is_exact ? mantissa : mantissa + 1, exponent); }
};

/// Requires x > 0. Past the range it is the largest double, and the next one is infinity.
Truncated truncated(const Rational& x) {
  static const Rational most = exact(std::numeric_limits<double>::max());
  if (x > most) return {(std::int64_t{1} << kMantissaBits) - 1, kMaxExponent, false};
  // The quotient below keeps at least 53 bits, or all down to the smallest subnormal; a second look
  // truncates it to 53.
  long shift = std::max(rough_exponent(x) - kMantissaBits - 1, kMinExponent);
  const Rational units = scaled(x, -shift);
  Integer q, rest;
  mpz_fdiv_qr(q.get_mpz_t(), rest.get_mpz_t(), units.get_num_mpz_t(), units.get_den_mpz_t());
  bool is_exact = rest == 0;
  const long extra = static_cast<long>(mpz_sizeinbase(q.get_mpz_t(), 2)) - kMantissaBits;
  if (extra > 0) {
    is_exact = is_exact && mpz_divisible_2exp_p(q.get_mpz_t(), static_cast<mp_bitcnt_t>(extra));
    mpz_fdiv_q_2exp(q.get_mpz_t(), q.get_mpz_t(), static_cast<mp_bitcnt_t>(extra));
    shift += extra;
  }
  return {q.get_si(), static_cast<int>(shift), is_exact};
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
  const int s = sgn(x);
  if (s == 0) return 0.0;
  return s > 0 ? truncated(x).down() : -truncated(-x).up();
}

double round_up(const Rational& x) {
  const int s = sgn(x);
  if (s == 0) return 0.0;
  return s > 0 ? truncated(x).up() : -truncated(-x).down();
}

std::optional<double> to_double_exactly(const Rational& x) {
  if (sgn(x) == 0) return 0.0;
  const Truncated t = truncated(abs(x));
  if (!t.is_exact) return std::nullopt;
  return sgn(x) > 0 ? t.down() : -t.down();
}

bool is_dyadic(const Rational& x) {
  return mpz_popcount(x.get_den_mpz_t()) == 1;
}

std::string to_text(const Rational& x) {
  return x.get_str();
}

Result<Rational> parse_rational(std::string_view text) {
  const auto refuse = [&] {
    constexpr size_t kShown = 60;
    return input_error("", fmt::format("\"{}{}\" is not a rational \"p\" or \"p/q\" with q > 0",
                                       text.substr(0, kShown), text.size() > kShown ? "…" : ""));
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
    return input_error("", fmt::format("has a numerator or denominator of {} digits; at most {} "
                                       "are read",
                                       longer, kMaxRationalDigits));
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
