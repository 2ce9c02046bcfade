#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "base/double_parts.hpp"
#include "generators/exact_sum.hpp"
#include "io/json_real.hpp"
#include "io/json_write.hpp"
#include "numeric/bounded_int.hpp"
#include "numeric/next_double.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Any finite double, or an ordinary one.
double draw_double(Draw& choices) {
  if (choices.coin()) return choices.finite_double();
  return *choices.dyadic(53, choices.integer(-60, 10)).to_double_exactly();
}

void check_rational_rounding(Draw& d) {
  const double x = draw_double(d);
  const Rational off = Rational(1, 3) * power_of_two(d.integer(-1100, 10));
  const Rational q = show(d, "q", d.coin() ? Rational(exact(x) + off) : exact(x));
  const double down = round_down(q), up = round_up(q);
  show(d, "down", down);
  show(d, "up", up);
  CLAIM(!std::isfinite(down) || exact(down) <= q);
  CLAIM(!std::isfinite(up) || q <= exact(up));
  CLAIM(down == up || next_up(down) == up);
  CLAIM(to_double_exactly(q).has_value() == (down == up));
}

template <int Bits>
Integer to_integer(const BoundedInt<Bits>& x) {
  Integer sum = 0;
  for (int i = x.limbs(); i-- > 0;) {
    sum <<= 64;
    sum += Integer(fmt::format("{}", x.limb(i)));
  }
  return x.sign() < 0 ? Integer(-sum) : sum;
}

/// Also where they grow and shrink by many limbs.
void check_bounded_int(Draw& d) {
  using Int = BoundedInt<1024>;
  constexpr std::int64_t kMost = std::int64_t{1} << 62;
  std::array<Int, 2> numbers;
  std::array<Integer, 2> expected;
  for (std::int64_t n = d.integer(1, 12); n > 0; --n) {
    const std::size_t to = show(d, "of number", d.choose(1));
    const std::int64_t x = d.integer(-kMost, kMost);
    const std::uint64_t operation = d.choose(4);
    const std::size_t bits = mpz_sizeinbase(expected[to].get_mpz_t(), 2);
    show(d, std::array{"=", "+", "-", "*", "<"}[operation], x);
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
    CLAIM(to_integer(numbers[i]) == expected[i]);
    CLAIM(numbers[i].sign() == sgn(expected[i]));
    CLAIM(abs(error) <= abs(Rational(expected[i])) * power_of_two(-52));
    CLAIM(expected[i] == 0 || (0.5 <= std::abs(mantissa) && std::abs(mantissa) <= 1));
  }
}

void check_double_parts(Draw& d) {
  const double x = show(d, "x", d.finite_double());
  const DoubleParts parts = parts_of(x);
  CLAIM(std::ldexp(static_cast<double>(parts.mantissa), parts.exponent) == x);
  CLAIM(x == 0 || (parts.mantissa % 2 != 0 && parts.top() == std::ilogb(x) + 1));
  CLAIM(double_of(parts.mantissa, parts.exponent) == x);
  CLAIM(next_up(x) == std::nextafter(x, HUGE_VAL));
  CLAIM(next_down(x) == std::nextafter(x, -HUGE_VAL));
  CLAIM(next_up(HUGE_VAL) == HUGE_VAL && next_down(-HUGE_VAL) == -HUGE_VAL);
}

void check_exact_sums(Draw& d) {
  const double a = show(d, "a", draw_double(d));
  const double b = show(d, "b", d.coin() ? draw_double(d) : d.nudged(-a, 20));
  double sum = a;
  const bool is_exact = add_exactly(sum, b);
  const std::optional<double> exact_sum = (Dyadic::exact(a) + Dyadic::exact(b)).to_double_exactly();
  show(d, "sum", sum);
  CLAIM(is_exact == exact_sum.has_value());
  CLAIM(!exact_sum || sum == *exact_sum);
}

void check_dyadic_round_trip(Draw& d) {
  const double x = show(d, "x", d.finite_double());
  // Near each other half of the time, where sums cancel.
  const bool is_near = d.coin();
  const double y = show(d, "y", is_near ? d.nudged(d.coin() ? -x : x, 4) : d.finite_double());
  const Dyadic dx = Dyadic::exact(x), dy = Dyadic::exact(y);
  const Rational rx = exact(x), ry = exact(y);
  const auto is_x = [&](const Result<double>& read) {
    return read && std::bit_cast<std::uint64_t>(*read) == std::bit_cast<std::uint64_t>(x);
  };
  CLAIM(is_x(parse_real({JsonKind::kNumber, json_number(x), {}, {}})));
  CLAIM(is_x(parse_real({JsonKind::kString, to_hex(x), {}, {}})));
  const Rational q = show(d, "q", rx / d.integer(1, 1000));
  const auto read = parse_rational(to_text(q));
  CLAIM(read && *read == q);
  CLAIM(dx.to_double_exactly() == std::optional(x));
  CLAIM(to_double_exactly(rx) == std::optional(x));
  CLAIM(dx.rational() == rx);
  CLAIM(Dyadic::from(rx) == std::optional(dx));
  CLAIM(Rational(rx + ry) == (dx + dy).rational());
  CLAIM(Rational(rx - ry) == (dx - dy).rational());
  CLAIM(Rational(rx * ry) == (dx * dy).rational());
  CLAIM((rx < ry) == (dx < dy));
  CLAIM((dx + dy) - dy == dx);
}

}  // namespace

std::vector<Property> arithmetic_claims() {
  return {
      {"rational.rounding", "round_down and round_up are the doubles next to a rational",
       "src/numeric/rational.hpp", check_rational_rounding},
      {"bounded_int.is_gmp", "Integers of bounded length agree with GMP",
       "src/numeric/bounded_int.hpp", check_bounded_int},
      {"double.parts", "A double is its mantissa times its power of two, and next_up is nextafter",
       "src/base/double_parts.hpp", check_double_parts},
      {"double.exact_sums", "A sum of doubles is known to be exact or rounded",
       "generators/exact_sum.hpp", check_exact_sums},
      {"paper.every_dyadic_is_a_double", "p/2^k with |p| < 2^53 is a double for any p and k",
       "Section 5.4, which leaves out the range of exponents",
       [](Draw& d) {
         const Dyadic x = show(d, "x", d.dyadic(53, d.integer(-2000, 2000)));
         CLAIM(x.to_double_exactly().has_value());
       },
       kFails},
      {"dyadic.round_trip",
       "A double goes to exact numbers and to the texts of files and back without loss, as a "
       "fraction does to its text. Both exact number types agree on every sum, difference, product "
       "and order",
       "Section 5.4", check_dyadic_round_trip},
  };
}

}  // namespace ccdfuzz
