#include <fmt/format.h>

#include "ccd/robustness.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

/// Lines in the order of their slopes, `count` of them in turn from a drawn place; nothing if there
/// are not so many.
std::vector<Line<double>> draw_sorted(Draw& choices, std::size_t count,
                                      const std::vector<Line<double>>& from) {
  if (from.size() < count) return {};
  const Lines<double> sorted = sorted_lines(from);
  const auto first = static_cast<int>(choices.choose(from.size() - count));
  return {sorted.begin() + first, sorted.begin() + first + static_cast<int>(count)};
}

/// Both forms of predicates on differences of lines, in any number type.
template <class S>
ProductDifference<S> product_form(const Line<S>& x, const Line<S>& y, const Line<S>& z) {
  return {S(z.slope - x.slope), S(y.intercept - x.intercept), S(y.slope - x.slope),
          S(z.intercept - x.intercept)};
}
template <class S>
EndValue<S> end_form(const Line<S>& x, const Line<S>& y, const S& t) {
  return {S(x.slope - y.slope), S(x.intercept - y.intercept), t};
}

Check failure(const std::vector<Line<double>>& lines, const char* what) {
  return Check::fails(fmt::format("lines {}: {}", to_hex_text(lines), what));
}

/// Eq. 13, both inequalities. Lines gamma − 1, gamma, alpha by rising slope.
Check check_eps_Phi(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  const auto lines = draw_sorted(choices, 3, pairs.f);
  if (lines.empty()) return Check::discarded("fewer than three lines");
  const ExactLines exact = exact_lines(lines);
  const auto phi = product_form(exact[0], exact[1], exact[2]);
  const double rounded = product_form(lines[0], lines[1], lines[2]).value();
  const Dyadic first = theorem_4_1_bound(phi.magnitude(), 4);
  const Dyadic second = theorem_4_1_bound(phi.p * (abs(phi.s) + abs(phi.q)), 4);
  if (first < abs(Dyadic::exact(rounded) - phi.value())) return failure(lines, "the first");
  return second < first ? failure(lines, "the second") : Check::holds();
}

/// Eqs. 14 and 15: the end value of two lines, t = tL or tU.
Check check_eps_end(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  const auto lines = draw_sorted(choices, 2, pairs.f);
  if (lines.empty()) return Check::discarded("fewer than two lines");
  const ExactLines exact = exact_lines(lines);
  for (const double t : {pairs.window.lo, pairs.window.hi}) {
    const auto phi = end_form(exact[0], exact[1], Dyadic::exact(t));
    const double rounded = end_form(lines[0], lines[1], t).value();
    if (theorem_4_1_bound(phi.magnitude(), 3) < abs(Dyadic::exact(rounded) - phi.value())) {
      return failure(lines, "at an end of the window");
    }
  }
  return Check::holds();
}

/// The differences that Psi_min has, of f = the max-envelope's line alpha and the min-envelope's
/// lines beta, beta + 1; `next_of_f` is alpha + 1.
struct PsiMin {
  Line<double> alpha, alpha_next, beta, beta_next;

  template <class S>
  ProductDifference<S> predicate(const Line<S>& f, const Line<S>& g, const Line<S>& g_next) const {
    return {S(f.slope - g_next.slope), S(f.intercept - g.intercept), S(f.slope - g.slope),
            S(f.intercept - g_next.intercept)};
  }
};

/// C.1 for Psi_min, with the bound's last factor as printed, |b_(alpha+1) − b_(beta+1)|, or as the
/// predicate has it, |b_alpha − b_(beta+1)|. Psi_max is the same with the roles exchanged.
Check eps_psi_min_holds(Draw& choices, bool as_printed) {
  const LinePairs pairs = draw_line_pairs(choices);
  const auto f = draw_sorted(choices, 2, pairs.f);
  std::vector<Line<double>> lower = pairs.g;  // of the negated lines
  for (Line<double>& line : lower) line = {-line.slope, -line.intercept};
  const auto g = draw_sorted(choices, 2, lower);
  if (f.empty() || g.empty()) return Check::discarded("fewer than two lines a side");
  const PsiMin psi{f[0], f[1], g[1], g[0]};
  const Line<Dyadic> alpha = exact_line(psi.alpha), beta = exact_line(psi.beta),
                     next = exact_line(psi.beta_next), alpha_next = exact_line(psi.alpha_next);
  const auto exact = psi.predicate(alpha, beta, next);
  const double rounded = psi.predicate(psi.alpha, psi.beta, psi.beta_next).value();
  const Dyadic last = as_printed ? alpha_next.intercept - next.intercept : exact.s;
  const Dyadic magnitude = abs(exact.p) * abs(exact.q) + abs(exact.r) * abs(last);
  if (abs(Dyadic::exact(rounded) - exact.value()) <= theorem_4_1_bound(magnitude, 4)) {
    return Check::holds();
  }
  return Check::fails(
      fmt::format("alpha, alpha + 1 {} and beta + 1, beta {}", to_hex_text(f), to_hex_text(g)));
}

/// A predicate that a policy takes for negative is negative, and the bound that it computes in
/// doubles is no less than the exact one. `scale`: the power of two on all intercepts and slopes.
Check decisions_are_conservative(Draw& choices, int scale) {
  const LinePairs pairs = draw_line_pairs(choices);
  auto lines = draw_sorted(choices, 3, pairs.f);
  if (lines.empty()) return Check::discarded("fewer than three lines");
  for (Line<double>& line : lines) {
    line = {std::ldexp(line.slope, scale), std::ldexp(line.intercept, scale)};
  }
  if (choices.coin()) std::swap(lines[0], lines[2]);
  const ExactLines exact = exact_lines(lines);
  const auto wrong = [&](const auto& rounded, const auto& truth) -> const char* {
    constexpr int kRoundings = std::remove_cvref_t<decltype(rounded)>::kRoundings;
    if (ErrorBoundIntended::negative(rounded) && truth.value().sign() >= 0) {
      return "it is not negative";
    }
    const double bound = ErrorBoundIntended::bound(rounded.magnitude(), kRoundings);
    return Dyadic::exact(bound) < theorem_4_1_bound(truth.magnitude(), kRoundings)
               ? "its bound is too small"
               : nullptr;
  };
  const double t = pairs.window.hi;
  const char* what =
      wrong(product_form(lines[0], lines[1], lines[2]), product_form(exact[0], exact[1], exact[2]));
  if (what == nullptr) {
    what = wrong(end_form(lines[0], lines[1], t), end_form(exact[0], exact[1], Dyadic::exact(t)));
  }
  return what == nullptr ? Check::holds() : failure(lines, what);
}

}  // namespace

std::vector<Property> predicates_claims() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"paper.eps_Phi", "Phi is off by at most eps_Phi, and both bounds are in the order given",
       "Eq. 13", kHolds, check_eps_Phi},
      {"paper.eps_phi", "Phi at t^L and phi at t^U are off by at most their eps", "Eqs. 14 and 15",
       kHolds, check_eps_end},
      {"paper.eps_Psi", "Psi_max and Psi_min are off by at most eps_Psi of their own operands",
       "Eq. 17, Appendix C.1", kHolds, [](Draw& c) { return eps_psi_min_holds(c, false); }},
      {"paper.eps_Psi_min_as_printed", "Psi_min is off by at most eps_Psi_min as printed",
       "Appendix C.1, with |b_(alpha+1) - b_(beta+1)|", kFails,
       [](Draw& c) { return eps_psi_min_holds(c, true); }},
      {"tdibm-e.conservative_decisions",
       "A predicate that counts as negative is negative, and its computed bound is no less than "
       "the exact one",
       "Sections 4.4 to 4.6, Appendix B", kHolds,
       [](Draw& c) { return decisions_are_conservative(c, 0); }},
      {"tdibm-e.conservative_decisions_underflow", "The same of lines about 2^-530",
       "Section 4.6, which does not exclude underflow", kFails,
       [](Draw& c) { return decisions_are_conservative(c, -530); }},
  };
}

}  // namespace ccdfuzz
