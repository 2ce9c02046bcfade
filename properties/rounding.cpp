#include "ccd/robustness.hpp"
#include "numeric/next_double.hpp"
#include "properties/error_bound.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// 0, or 2^-40 to 2^80 in magnitude, with up to 53 bits: no product of a few leaves the range.
double draw_ordinary(Draw& choices) {
  constexpr int kBits = 53;
  const int exponent = choices.integer(-40, 27);
  return *choices.dyadic(kBits, exponent).to_double_exactly();
}

enum class Strictness : std::uint8_t { kAsPrinted, kWithEquality };

/// |a ⊗ b as a double − a ⊗ b| < |a ⊗ b|·eps for the four operations; ≤ with equality.
std::function<void(Draw&)> rounds_within_eps(double (*draw_one)(Draw&), Strictness strictness) {
  return [=](Draw& d) {
    const double a = draw_one(d), b = draw_one(d);
    const Dyadic x = Dyadic::exact(a), y = Dyadic::exact(b), eps = section_4_3_epsilon();
    const auto is_within = [&](const Dyadic& error, const Dyadic& exact) {
      const Dyadic bound = abs(exact) * eps;
      return strictness == Strictness::kAsPrinted ? abs(error) < bound : abs(error) <= bound;
    };
    const double sum = a + b, difference = a - b, product = a * b;
    show(d, "a", a);
    show(d, "b", b);
    suppose(std::isfinite(sum) && std::isfinite(difference) && std::isfinite(product));
    CLAIM(is_within(Dyadic::exact(sum) - (x + y), x + y));
    CLAIM(is_within(Dyadic::exact(difference) - (x - y), x - y));
    CLAIM(is_within(Dyadic::exact(product) - x * y, x * y));
    if (b == 0) return;
    const double quotient = a / b;
    suppose(std::isfinite(quotient));
    // Both sides of the inequality times |b|.
    CLAIM(is_within(Dyadic::exact(quotient) * y - x, x));
  };
}

/// A number on its way through an expression: as a double, exactly, and B and k of Theorem 4.1.
struct Operand {
  double rounded = 0;
  Dyadic exact, magnitude;
  int roundings = 0;
  long grid = 0;  ///< rounded is a multiple of 2^grid
  long top = 0;   ///< magnitude < 2^top
};

/// From up to 4 numbers, up to 6 operations. `lowest`: no product becomes a multiple of less than
/// 2^lowest.
void claim_theorem_4_1(Draw& d, long exponent, long lowest) {
  constexpr long kBits = 24, kMostTop = 900;
  std::vector<Operand> pool;
  for (std::int64_t n = d.integer(2, 4); n > 0; --n) {
    const Dyadic x = d.dyadic(kBits, exponent);
    const double value = show(d, "number", *x.to_double_exactly());
    pool.push_back({value, x, abs(x), 0, exponent, exponent + kBits});
  }
  for (std::int64_t n = d.integer(1, 6); n > 0; --n) {
    const Operand& l = pool[d.choose(pool.size() - 1)];
    const Operand& r = pool[d.choose(pool.size() - 1)];
    const std::uint64_t operation = d.choose(2);
    const bool times = operation == 2 && l.grid + r.grid >= lowest && l.top + r.top <= kMostTop;
    const bool minus = operation == 1;
    Operand o;
    if (times) {
      o = {l.rounded * r.rounded,         l.exact * r.exact, l.magnitude * r.magnitude,
           l.roundings + r.roundings + 1, l.grid + r.grid,   l.top + r.top};
    } else {
      o = {minus ? l.rounded - r.rounded : l.rounded + r.rounded,
           minus ? l.exact - r.exact : l.exact + r.exact,
           l.magnitude + r.magnitude,
           std::max(l.roundings, r.roundings) + 1,
           std::min(l.grid, r.grid),
           std::max(l.top, r.top) + 1};
    }
    show(d,
         times   ? "product of"
         : minus ? "difference of"
                 : "sum of",
         std::array{l.rounded, r.rounded});
    show(d, "rounded to", o.rounded);
    show(d, "B", o.magnitude);
    show(d, "k", o.roundings);
    const Dyadic error = abs(Dyadic::exact(o.rounded) - o.exact);
    CLAIM(error <= theorem_4_1_bound(o.magnitude, o.roundings));
    pool.push_back(std::move(o));
  }
}

void check_linear_bound(Draw& d) {
  const double magnitude = show(d, "B", std::abs(draw_ordinary(d)));
  const int roundings = show(d, "k", d.integer(1, 100));
  const double bound = show(d, "bound", ErrorBoundIntended::bound(magnitude, roundings));
  CLAIM(theorem_4_1_bound(Dyadic::exact(magnitude), roundings) <= Dyadic::exact(bound));
}

void check_nextafter_bounds(Draw& d) {
  const double x = d.finite_double(), e = std::abs(d.finite_double());
  const double up = next_up(x + e), down = next_down(x - e);
  const Dyadic exact_x = Dyadic::exact(x), exact_e = Dyadic::exact(e);
  show(d, "x", x);
  show(d, "e", e);
  CLAIM(!std::isfinite(up) || exact_x + exact_e <= Dyadic::exact(up));
  CLAIM(!std::isfinite(down) || Dyadic::exact(down) <= exact_x - exact_e);
}

void check_nextafter_is_smallest(Draw& d) {
  const double x = draw_ordinary(d), e = std::abs(draw_ordinary(d));
  const double below = next_down(next_up(x + e));
  show(d, "x", x);
  show(d, "e", e);
  CLAIM(Dyadic::exact(below) <= Dyadic::exact(x) + Dyadic::exact(e));
}

}  // namespace

std::vector<Property> rounding_claims() {
  return {
      {"paper.rounding_as_printed",
       "The error of +, -, *, / is strictly less than eps times the exact result", "Section 4.3",
       rounds_within_eps(draw_ordinary, Strictness::kAsPrinted), kFails},
      {"paper.rounding",
       "The error of +, -, *, / is at most eps times the exact result, far from the ends of the "
       "range",
       "Section 4.3", rounds_within_eps(draw_ordinary, Strictness::kWithEquality)},
      {"paper.rounding_anywhere",
       "The error of +, -, *, / is at most eps times the exact result, for any doubles",
       "Section 4.3, which excludes none",
       rounds_within_eps([](Draw& d) { return d.finite_double(); }, Strictness::kWithEquality),
       kFails},
      {"paper.theorem_4_1",
       "The error of an expression in +, -, * is at most B[(1+eps)^k - 1], far from underflow",
       "Theorem 4.1", [](Draw& d) { claim_theorem_4_1(d, d.integer(-40, 20), -1000); }},
      {"paper.theorem_4_1_underflow",
       "The error of an expression in +, -, * is at most B[(1+eps)^k - 1], for numbers about "
       "2^-530",
       "Theorem 4.1, which does not exclude underflow",
       [](Draw& d) { claim_theorem_4_1(d, -540, -1'000'000); }, kFails},
      {"paper.linear_bound", "2Bk eps, computed in doubles, is at least B[(1+eps)^k - 1]",
       "Appendix B", check_linear_bound},
      {"paper.nextafter_bounds",
       "nextafter above the computed x + e is at least x + e, and below x - e at most x - e",
       "Appendix B", check_nextafter_bounds},
      {"paper.nextafter_is_smallest",
       "nextafter above the computed x + e is the smallest double greater than x + e", "Appendix B",
       check_nextafter_is_smallest, kFails},
  };
}

}  // namespace ccdfuzz
