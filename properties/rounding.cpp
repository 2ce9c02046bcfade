#include <fmt/format.h>

#include "ccd/next_double.hpp"
#include "ccd/robustness.hpp"
#include "properties/error_bound.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

/// 0, or 2^-40 to 2^80 in magnitude, with up to 53 bits: no product of a few leaves the range.
double draw_ordinary(Draw& choices) {
  constexpr int kBits = 53;
  const auto exponent = static_cast<long>(choices.integer(-40, 27));
  return *choices.dyadic(kBits, exponent).to_double_exactly();
}

enum class Strictness : std::uint8_t { kAsPrinted, kWithEquality };

/// |a ⊗ b as a double − a ⊗ b| < |a ⊗ b|·eps for the four operations; ≤ with equality.
Check operations_round_within_eps(double a, double b, Strictness strictness) {
  const Dyadic x = Dyadic::exact(a), y = Dyadic::exact(b), eps = section_4_3_epsilon();
  const auto within = [&](const Dyadic& error, const Dyadic& exact) {
    const Dyadic bound = abs(exact) * eps;
    return strictness == Strictness::kAsPrinted ? abs(error) < bound : abs(error) <= bound;
  };
  const auto failure = [&](const char* operation, double result) {
    return Check::fails(
        fmt::format("{} {} {} is rounded to {}", to_hex(a), operation, to_hex(b), to_hex(result)));
  };
  const double sum = a + b, difference = a - b, product = a * b;
  for (const double result : {sum, difference, product}) {
    if (!std::isfinite(result)) return Check::discarded("it overflows");
  }
  if (!within(Dyadic::exact(sum) - (x + y), x + y)) return failure("+", sum);
  if (!within(Dyadic::exact(difference) - (x - y), x - y)) return failure("-", difference);
  if (!within(Dyadic::exact(product) - x * y, x * y)) return failure("*", product);
  if (b == 0) return Check::holds();
  const double quotient = a / b;
  if (!std::isfinite(quotient)) return Check::discarded("it overflows");
  // Both sides of the inequality times |b|.
  if (!within(Dyadic::exact(quotient) * y - x, x)) return failure("/", quotient);
  return Check::holds();
}

Check check_rounding_as_printed(Draw& choices) {
  const double a = draw_ordinary(choices), b = draw_ordinary(choices);
  return operations_round_within_eps(a, b, Strictness::kAsPrinted);
}

Check check_rounding(Draw& choices) {
  const double a = draw_ordinary(choices), b = draw_ordinary(choices);
  return operations_round_within_eps(a, b, Strictness::kWithEquality);
}

Check check_rounding_anywhere(Draw& choices) {
  const double a = choices.finite_double(), b = choices.finite_double();
  return operations_round_within_eps(a, b, Strictness::kWithEquality);
}

/// A number on its way through an expression: as a double, exactly, and B and k of Theorem 4.1.
struct Operand {
  double rounded = 0;
  Dyadic exact, magnitude;
  int roundings = 0;
  long grid = 0;  ///< rounded is a multiple of 2^grid
  long top = 0;   ///< magnitude < 2^top
  std::string text;
};

/// From up to 4 numbers, up to 6 operations. `lowest`: no product becomes a multiple of less than
/// 2^lowest.
Check theorem_4_1_holds(Draw& choices, long exponent, long lowest) {
  constexpr long kBits = 24, kMostTop = 900;
  std::vector<Operand> pool;
  for (std::int64_t n = choices.integer(2, 4); n > 0; --n) {
    const Dyadic x = choices.dyadic(kBits, exponent);
    const double value = *x.to_double_exactly();
    pool.push_back({value, x, abs(x), 0, exponent, exponent + kBits, to_hex(value)});
  }
  for (std::int64_t n = choices.integer(1, 6); n > 0; --n) {
    const Operand& l = pool[choices.choose(pool.size() - 1)];
    const Operand& r = pool[choices.choose(pool.size() - 1)];
    const std::uint64_t operation = choices.choose(2);
    Operand o;
    if (operation == 2 && l.grid + r.grid >= lowest && l.top + r.top <= kMostTop) {
      o = {l.rounded * r.rounded,
           l.exact * r.exact,
           l.magnitude * r.magnitude,
           l.roundings + r.roundings + 1,
           l.grid + r.grid,
           l.top + r.top,
           fmt::format("({} * {})", l.text, r.text)};
    } else {
      const bool minus = operation == 1;
      o = {minus ? l.rounded - r.rounded : l.rounded + r.rounded,
           minus ? l.exact - r.exact : l.exact + r.exact,
           l.magnitude + r.magnitude,
           std::max(l.roundings, r.roundings) + 1,
           std::min(l.grid, r.grid),
           std::max(l.top, r.top) + 1,
           fmt::format("({} {} {})", l.text, minus ? '-' : '+', r.text)};
    }
    const Dyadic error = abs(Dyadic::exact(o.rounded) - o.exact);
    if (theorem_4_1_bound(o.magnitude, o.roundings) < error) {
      return Check::fails(fmt::format("{} is {}: off by more than B = {}, k = {} allow", o.text,
                                      to_hex(o.rounded), to_text(o.magnitude.rational()),
                                      o.roundings));
    }
    pool.push_back(std::move(o));
  }
  return Check::holds();
}

Check check_theorem_4_1(Draw& choices) {
  return theorem_4_1_holds(choices, static_cast<long>(choices.integer(-40, 20)), -1000);
}

Check check_theorem_4_1_underflow(Draw& choices) {
  return theorem_4_1_holds(choices, -540, -1'000'000);
}

Check check_linear_bound(Draw& choices) {
  const double magnitude = std::abs(draw_ordinary(choices));
  const auto roundings = static_cast<int>(choices.integer(1, 100));
  const double bound = ErrorBoundIntended::bound(magnitude, roundings);
  if (theorem_4_1_bound(Dyadic::exact(magnitude), roundings) <= Dyadic::exact(bound)) {
    return Check::holds();
  }
  return Check::fails(
      fmt::format("B = {}, k = {}: {} is too small", to_hex(magnitude), roundings, to_hex(bound)));
}

/// nextafter above fl(x + e) is no less than x + e, and below fl(x − e) no more than x − e.
Check check_nextafter_bounds(Draw& choices) {
  const double x = choices.finite_double(), e = std::abs(choices.finite_double());
  const double up = next_up(x + e), down = next_down(x - e);
  const Dyadic exact_x = Dyadic::exact(x), exact_e = Dyadic::exact(e);
  if (std::isfinite(up) && Dyadic::exact(up) < exact_x + exact_e) {
    return Check::fails(fmt::format("{} + {}: {} is below", to_hex(x), to_hex(e), to_hex(up)));
  }
  if (std::isfinite(down) && exact_x - exact_e < Dyadic::exact(down)) {
    return Check::fails(fmt::format("{} - {}: {} is above", to_hex(x), to_hex(e), to_hex(down)));
  }
  return Check::holds();
}

/// Appendix B calls that the smallest double that is greater than x + e.
Check check_nextafter_is_smallest(Draw& choices) {
  const double x = draw_ordinary(choices), e = std::abs(draw_ordinary(choices));
  const double up = next_up(x + e);
  if (Dyadic::exact(next_down(up)) <= Dyadic::exact(x) + Dyadic::exact(e)) return Check::holds();
  return Check::fails(
      fmt::format("{} + {}: the double below {} is greater too", to_hex(x), to_hex(e), to_hex(up)));
}

}  // namespace

std::vector<Property> rounding_claims() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"paper.rounding_as_printed",
       "The error of +, -, *, / is strictly less than eps times the exact result", "Section 4.3",
       kFails, check_rounding_as_printed},
      {"paper.rounding",
       "The error of +, -, *, / is at most eps times the exact result, far from the ends of the "
       "range",
       "Section 4.3", kHolds, check_rounding},
      {"paper.rounding_anywhere",
       "The error of +, -, *, / is at most eps times the exact result, for any doubles",
       "Section 4.3, which excludes none", kFails, check_rounding_anywhere},
      {"paper.theorem_4_1",
       "The error of an expression in +, -, * is at most B[(1+eps)^k - 1], far from underflow",
       "Theorem 4.1", kHolds, check_theorem_4_1},
      {"paper.theorem_4_1_underflow", "The same of expressions in numbers about 2^-530",
       "Theorem 4.1, which does not exclude underflow", kFails, check_theorem_4_1_underflow},
      {"paper.linear_bound", "2Bk eps, computed in doubles, is at least B[(1+eps)^k - 1]",
       "Appendix B", kHolds, check_linear_bound},
      {"paper.nextafter_bounds",
       "nextafter above the computed x + e is at least x + e, and below x - e at most x - e",
       "Appendix B", kHolds, check_nextafter_bounds},
      {"paper.nextafter_is_smallest",
       "nextafter above the computed x + e is the smallest double greater than x + e", "Appendix B",
       kFails, check_nextafter_is_smallest},
  };
}

}  // namespace ccdfuzz
