#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/double_parts.hpp"
#include "base/json_real.hpp"
#include "base/json_write.hpp"
#include "ccd/next_double.hpp"
#include "generators/exact_sum.hpp"
#include "numeric/bounded_int.hpp"
#include "numeric/wide_int.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

/// Any finite double, or an ordinary one.
double draw_double(Draw& choices) {
  if (choices.coin()) return choices.finite_double();
  return *choices.dyadic(53, static_cast<long>(choices.integer(-60, 10))).to_double_exactly();
}

/// Rounding down and up are the neighbours of any rational, and equal where it is a double.
Check check_rational_rounding(Draw& choices) {
  const double x = draw_double(choices);
  const Rational off = Rational(1, 3) * power_of_two(static_cast<long>(choices.integer(-1100, 10)));
  const Rational q = choices.coin() ? Rational(exact(x) + off) : exact(x);
  const double down = round_down(q), up = round_up(q);
  const auto fails = [&](const char* what) {
    return Check::fails(fmt::format("{}: {}", to_text(q), what));
  };
  if (std::isfinite(down) && q < exact(down)) return fails("rounded down to above");
  if (std::isfinite(up) && exact(up) < q) return fails("rounded up to below");
  if (down != up && next_up(down) != up) return fails("not neighbours");
  if (to_double_exactly(q).has_value() != (down == up)) return fails("exact in one way only");
  return Check::holds();
}

template <int Bits>
Integer to_integer(const WideInt<Bits>& x) {
  Integer sum = 0;
  for (int i = Bits / 64; i-- > 0;) {
    sum <<= 64;
    sum += Integer(fmt::format("{}", x.limb(i)));
  }
  Integer half = 1;
  half <<= Bits - 1;
  return sum >= half ? Integer(sum - 2 * half) : sum;
}

/// The fixed-width integers agree with GMP as long as nothing leaves their range.
Check check_wide_int(Draw& choices) {
  WideInt<192> sum(0);
  Integer expected = 0;
  std::string steps;
  for (std::int64_t n = choices.integer(1, 5); n > 0; --n) {
    const std::int64_t x = choices.integer(-(std::int64_t{1} << 61), std::int64_t{1} << 61);
    const std::uint64_t operation = choices.choose(3);
    const Integer exact_x(static_cast<long>(x));
    steps += fmt::format(" {}{}", "+-*<"[operation], x);
    if (operation == 0) sum += WideInt<192>(x), expected += exact_x;
    if (operation == 1) sum -= WideInt<192>(x), expected -= exact_x;
    if (operation == 2 && mpz_sizeinbase(expected.get_mpz_t(), 2) < 100) {
      sum *= x, expected *= exact_x;
    }
    if (operation == 3 && mpz_sizeinbase(expected.get_mpz_t(), 2) < 120) sum <<= 9, expected <<= 9;
  }
  if (to_integer(sum) != expected || sum.sign() != sgn(expected)) return Check::fails("0" + steps);
  const std::int64_t x = choices.integer(-(std::int64_t{1} << 61), std::int64_t{1} << 61);
  const WideInt<128> factor = WideInt<128>(x) << static_cast<int>(choices.choose(65));
  const auto product = factor * sum;
  if (to_integer(product) != to_integer(factor) * expected) {
    return Check::fails(fmt::format("0{} times {}", steps, to_integer(factor).get_str()));
  }
  const Rational off = abs(exact(product.approximate()) - Rational(to_integer(product)));
  if (off * power_of_two(52) <= abs(to_integer(product))) return Check::holds();
  return Check::fails(fmt::format("about {}", to_integer(product).get_str()));
}

/// Integers of bounded length agree with GMP, also where they grow and shrink by many limbs.
Check check_bounded_int(Draw& choices) {
  using Int = BoundedInt<1024>;
  const auto to_gmp = [](const Int& x) {
    Integer sum = 0;
    for (int i = x.limbs(); i-- > 0;) {
      sum <<= 64;
      sum += Integer(fmt::format("{}", x.limb(i)));
    }
    return x.sign() < 0 ? Integer(-sum) : sum;
  };
  std::array<Int, 2> numbers;
  std::array<Integer, 2> expected;
  std::string steps;
  for (std::int64_t n = choices.integer(1, 12); n > 0; --n) {
    const std::size_t to = choices.choose(1);
    const std::int64_t x = choices.integer(-(std::int64_t{1} << 62), std::int64_t{1} << 62);
    const std::uint64_t operation = choices.choose(4);
    const std::size_t bits = mpz_sizeinbase(expected[to].get_mpz_t(), 2);
    steps += fmt::format(" {}{}{}", "ab"[to], "=+-*<"[operation], x);
    if (operation == 0) numbers[to] = Int(x), expected[to] = Integer(static_cast<long>(x));
    if (operation == 1) numbers[to] += numbers[1 - to], expected[to] += expected[1 - to];
    if (operation == 2) numbers[to] -= numbers[1 - to], expected[to] -= expected[1 - to];
    const bool fits = bits + mpz_sizeinbase(expected[1 - to].get_mpz_t(), 2) < 960;
    if (operation == 3 && fits) {
      numbers[to] = numbers[to] * numbers[1 - to], expected[to] *= expected[1 - to];
    }
    if (operation == 4 && bits < 500) {
      const int shift = static_cast<int>(x & 127);
      numbers[to] = numbers[to] << shift, expected[to] <<= static_cast<mp_bitcnt_t>(shift);
    }
    if (bits > 940) numbers[to] = Int(), expected[to] = 0;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [mantissa, exponent] = numbers[i].approximate();
    const Rational error = exact(mantissa) * power_of_two(exponent) - Rational(expected[i]);
    const bool near = abs(error) <= abs(Rational(expected[i])) * power_of_two(-52);
    if (to_gmp(numbers[i]) != expected[i] || numbers[i].sign() != sgn(expected[i]) || !near) {
      return Check::fails(steps);
    }
  }
  return Check::holds();
}

/// A double is its parts, and next_up is nextafter.
Check check_double_parts(Draw& choices) {
  const double x = choices.finite_double();
  const DoubleParts parts = parts_of(x);
  const double again = std::ldexp(static_cast<double>(parts.mantissa), parts.exponent);
  const bool same = again == x && (x == 0 || parts.mantissa % 2 != 0) &&
                    next_up(x) == std::nextafter(x, HUGE_VAL) &&
                    next_down(x) == std::nextafter(x, -HUGE_VAL);
  return same ? Check::holds() : Check::fails(to_hex(x));
}

/// Numbers come back from their texts: shortest decimals, hex floats, "p/q".
Check check_number_texts(Draw& choices) {
  const double x = choices.finite_double();
  const auto same = [&](const Result<double>& read) {
    return read && std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(x);
  };
  if (!same(parse_real({JsonKind::kNumber, json_number(x), {}, {}}))) {
    return Check::fails("as a decimal: " + to_hex(x));
  }
  if (!same(parse_real({JsonKind::kString, to_hex(x), {}, {}}))) {
    return Check::fails("as a hex float: " + to_hex(x));
  }
  const Rational q = exact(x) / Rational(static_cast<long>(choices.integer(1, 1000)));
  const Result<Rational> read = parse_rational(to_text(q));
  return read && *read == q ? Check::holds() : Check::fails("as a fraction: " + to_text(q));
}

/// Section 5.4: p / 2^k with |p| < 2^53 is a double, for any integers p and k.
Check check_every_dyadic_is_a_double(Draw& choices) {
  const Dyadic x = choices.dyadic(53, static_cast<long>(choices.integer(-2000, 2000)));
  return x.to_double_exactly() ? Check::holds() : Check::fails(to_text(x.rational()));
}

Check check_exact_sums(Draw& choices) {
  const double a = draw_double(choices);
  const double b = choices.coin() ? draw_double(choices) : choices.nudged(-a, 20);
  double sum = a;
  const bool is_exact = add_exactly(sum, b);
  const std::optional<double> exact_sum = (Dyadic::exact(a) + Dyadic::exact(b)).to_double_exactly();
  const bool holds = exact_sum ? is_exact && sum == *exact_sum : !is_exact;
  if (holds) return Check::holds();
  return Check::fails(fmt::format("{} + {} is said to be {} {}", to_hex(a), to_hex(b),
                                  is_exact ? "exactly" : "about", to_hex(sum)));
}

}  // namespace

std::vector<Property> arithmetic_claims() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"rational.rounding", "round_down and round_up are the doubles next to a rational",
       "src/numeric/rational.hpp", kHolds, check_rational_rounding},
      {"wide_int.is_gmp", "Fixed-width integers agree with GMP within their range",
       "src/numeric/wide_int.hpp", kHolds, check_wide_int},
      {"bounded_int.is_gmp", "Integers of bounded length agree with GMP",
       "src/numeric/bounded_int.hpp", kHolds, check_bounded_int},
      {"double.parts", "A double is its mantissa times its power of two, and next_up is nextafter",
       "src/base/double_parts.hpp", kHolds, check_double_parts},
      {"double.exact_sums", "A sum of doubles is told from a rounded one",
       "generators/exact_sum.hpp", kHolds, check_exact_sums},
      {"number.texts", "Numbers come back from the texts that files hold", "the case format",
       kHolds, check_number_texts},
      {"paper.every_dyadic_is_a_double", "p/2^k with |p| < 2^53 is a double for any p and k",
       "Section 5.4, which leaves out the range of exponents", kFails,
       check_every_dyadic_is_a_double},
  };
}

}  // namespace ccdfuzz
