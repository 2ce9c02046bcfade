#include "ccd/robustness.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Both inequalities of Eq. 13, of lines gamma − 1, gamma, alpha by rising slope. Then the end
/// value of the first two, t = tL or tU.
void check_eps_Phi(Draw& d) {
  const LinePairs pairs = draw_line_pairs(d);
  const auto lines = show(d, "lines", draw_sorted(d, 3, pairs.f));
  const ExactLines exact = exact_lines(lines);
  const auto phi = product_form(exact[0], exact[1], exact[2]);
  const double rounded = product_form(lines[0], lines[1], lines[2]).value();
  const Dyadic first = theorem_4_1_bound(phi.magnitude(), 4);
  const Dyadic second = theorem_4_1_bound(phi.p * (abs(phi.s) + abs(phi.q)), 4);
  CLAIM(abs(Dyadic::exact(rounded) - phi.value()) <= first);
  CLAIM(first <= second);
  for (const double t : {pairs.window.lo, pairs.window.hi}) {
    const auto end = end_form(exact[0], exact[1], Dyadic::exact(t));
    const double value = end_form(lines[0], lines[1], t).value();
    show(d, "t", t);
    CLAIM(abs(Dyadic::exact(value) - end.value()) <= theorem_4_1_bound(end.magnitude(), 3));
  }
}

/// C.1 for Psi_min. f are the max-envelope's lines alpha and alpha + 1, g the min-envelope's lines
/// beta + 1 and beta. The bound's last factor is as printed, |b_(alpha+1) − b_(beta+1)|, or as the
/// predicate has it, |b_alpha − b_(beta+1)|. Psi_max is the same with the roles exchanged.
void claim_eps_psi_min(Draw& d, bool as_printed) {
  const LinePairs pairs = draw_line_pairs(d);
  const auto f = show(d, "alpha, alpha + 1", draw_sorted(d, 2, pairs.f));
  std::vector<Line<double>> lower = pairs.g;  // of the negated lines
  for (Line<double>& line : lower) line = {-line.slope, -line.intercept};
  const auto g = show(d, "beta + 1, beta", draw_sorted(d, 2, lower));
  // All four differences of Psi_min have the other sign here, which changes no bit of it.
  const auto exact = product_form(exact_line(f[0]), exact_line(g[1]), exact_line(g[0]));
  const double rounded = product_form(f[0], g[1], g[0]).value();
  const Dyadic last =
      as_printed ? exact_line(f[1]).intercept - exact_line(g[0]).intercept : exact.s;
  const Dyadic magnitude = abs(exact.p) * abs(exact.q) + abs(exact.r) * abs(last);
  CLAIM(abs(Dyadic::exact(rounded) - exact.value()) <= theorem_4_1_bound(magnitude, 4));
}

template <template <class> class Predicate>
void claim_conservative(const Predicate<double>& rounded, const Predicate<Dyadic>& truth) {
  constexpr int kRoundings = Predicate<double>::kRoundings;
  CLAIM(!ErrorBoundIntended::negative(rounded) || truth.value().sign() < 0);
  const double bound = ErrorBoundIntended::bound(rounded.magnitude(), kRoundings);
  CLAIM(theorem_4_1_bound(truth.magnitude(), kRoundings) <= Dyadic::exact(bound));
}

/// `scale`: the power of two on all intercepts and slopes.
std::function<void(Draw&)> decisions_are_conservative(int scale) {
  return [=](Draw& d) {
    const LinePairs pairs = draw_line_pairs(d);
    auto lines = draw_sorted(d, 3, pairs.f);
    for (Line<double>& line : lines) {
      line = {std::ldexp(line.slope, scale), std::ldexp(line.intercept, scale)};
    }
    if (d.coin()) std::swap(lines[0], lines[2]);
    const ExactLines exact = exact_lines(lines);
    const double t = show(d, "t", pairs.window.hi);
    show(d, "lines", lines);
    claim_conservative(product_form(lines[0], lines[1], lines[2]),
                       product_form(exact[0], exact[1], exact[2]));
    claim_conservative(end_form(lines[0], lines[1], t),
                       end_form(exact[0], exact[1], Dyadic::exact(t)));
  };
}

}  // namespace

std::vector<Property> predicates_claims() {
  return {
      {"paper.eps_Phi",
       "Phi, and phi at t^L and t^U, are off by at most their eps; both bounds of Phi are in the "
       "order given",
       "Eqs. 13 to 15", check_eps_Phi},
      {"paper.eps_Psi", "Psi_max and Psi_min are off by at most eps_Psi of their own operands",
       "Eq. 17, Appendix C.1", [](Draw& d) { claim_eps_psi_min(d, false); }},
      {"paper.eps_Psi_min_as_printed", "Psi_min is off by at most eps_Psi_min as printed",
       "Appendix C.1, with |b_(alpha+1) - b_(beta+1)|", [](Draw& d) { claim_eps_psi_min(d, true); },
       kFails},
      {"tdibm-e.conservative_decisions",
       "A predicate that counts as negative is negative, and its computed bound is no less than "
       "the exact one",
       "Sections 4.4 to 4.6, Appendix B", decisions_are_conservative(0)},
      {"tdibm-e.conservative_decisions_underflow",
       "A predicate that counts as negative is negative, and its computed bound is no less than "
       "the exact one, for lines about 2^-530",
       "Section 4.6, which does not exclude underflow", decisions_are_conservative(-530), kFails},
  };
}

}  // namespace ccdfuzz
