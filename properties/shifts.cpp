#include <algorithm>

#include "ccd/robustness.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// eps_constr = t·eps_a + eps_b + eps_arith.
void check_eps_constr(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  const Lines<double> sorted = sorted_lines(pairs.f);
  CoefficientError error;
  error.slope = *abs(d.dyadic(53, -105)).to_double_exactly();
  error.intercept = *abs(d.dyadic(53, -105)).to_double_exactly();
  const double t = pairs.window.hi;
  const double computed = show(d, "computed", ErrorBoundIntended::envelope_error(sorted, error, t));

  const Dyadic arithmetic = eps_arith(exact_lines(sorted), Dyadic::exact(t));
  const Dyadic coefficients =
      Dyadic::exact(t) * Dyadic::exact(error.slope) + Dyadic::exact(error.intercept);
  // A product and two sums of numbers ≥ 0, each at most u too low. Appendix B leaves room for
  // eps_arith alone.
  const Dyadic lost = coefficients * half_ulp().scaled(2);
  show(d, "eps_a", error.slope);
  show(d, "eps_b", error.intercept);
  CLAIM(coefficients - lost + arithmetic <= Dyadic::exact(computed));
}

/// Section 4.5: pull both envelopes apart by I·delta, I the steps from the end at which the sweep
/// began. An end of a separated interval is where these meet, or further inward.
void check_pulled_roots(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  const Lines<double> f = sorted_lines(pairs.f), g = sorted_lines(pairs.g);
  const auto draw_index = [&](const Lines<double>& lines) {
    return static_cast<int>(d.choose(static_cast<std::uint64_t>(lines.size() - 1)));
  };
  const int i = show(d, "i", draw_index(f));
  const int j = show(d, "j", draw_index(g));
  const ExactLines fx = exact_lines(f), gx = exact_lines(g);
  const auto [f_low, f_high] = intercept_range(fx);
  const auto [g_low, g_high] = intercept_range(gx);
  const Dyadic low = abs(f_low + g_low), high = abs(f_high + g_high);
  const Dyadic delta = theorem_4_1_bound(std::max(low, high).scaled(1), 4);
  const auto at = [](const ExactLines& lines, int k) -> const Line<Dyadic>& {
    return lines[static_cast<std::size_t>(k)];
  };
  const Dyadic slope = at(fx, i).slope + at(gx, j).slope;
  suppose(slope.sign() != 0);
  const bool is_left = slope.sign() < 0;  // separated where the sum of both is below 0
  const int steps = is_left ? i + j : (f.size() - 1 - i) + (g.size() - 1 - j);
  const Dyadic intercept =
      at(fx, i).intercept + at(gx, j).intercept + (Dyadic(steps) * delta).scaled(1);
  const double end = is_left ? ErrorBoundIntended().left_root(f, g, i, j, pairs.window)
                             : ErrorBoundIntended().right_root(f, g, i, j, pairs.window);
  // slope·end + intercept ≤ 0 inside of the root; an end at the window's own excludes nothing.
  const bool excludes = is_left ? end < pairs.window.hi : pairs.window.lo < end;
  show(d, is_left ? "tL" : "tR", end);
  CLAIM(!excludes || (slope * Dyadic::exact(end) + intercept).sign() <= 0);
}

}  // namespace

std::vector<Property> shifts_claims() {
  return {
      {"tdibm-e.eps_constr",
       "What envelopes are shifted by is no less than eps_coeff + eps_arith, up to three roundings "
       "of eps_coeff",
       "Eqs. 11, 12, 16", check_eps_constr},
      {"tdibm-e.pulled_roots",
       "An end of a separated interval is no further out than where envelopes meet that are pulled "
       "apart by I delta each",
       "Section 4.5", check_pulled_roots},
  };
}

}  // namespace ccdfuzz
