#include "properties/envelope.hpp"
#include "properties/error_bound.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// Eq. 12.
void check_eps_coeff(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  ExactLines exact = exact_lines(pairs.f), off;
  const Dyadic eps_a = d.dyadic(8, -40), eps_b = d.dyadic(8, -40);
  for (const Line<Dyadic>& line : exact) {
    const auto share = [&] { return d.dyadic(4, -4); };  // in (−1, 1)
    const Dyadic slope = line.slope + eps_a * share();
    const Dyadic intercept = line.intercept + eps_b * share();
    off.push_back({slope, intercept});
  }
  const Dyadic hi = Dyadic::exact(pairs.window.hi), lo = Dyadic::exact(pairs.window.lo);
  const Dyadic bound = hi * abs(eps_a) + abs(eps_b);
  show(d, "eps_a", eps_a);
  show(d, "eps_b", eps_b);
  // The difference of the two maxima is linear between the breakpoints of both.
  for (const ExactLines& turning : {exact, off}) {
    for (const Instant& t : breakpoints(turning, lo, hi)) {
      CLAIM(abs(scaled_maximum(off, t) - scaled_maximum(exact, t)) <= bound * t.q);
    }
  }
}

/// A line that is not pushed since the computed phi ≥ −eps_phi is above the top of the stack at tU
/// by at most `factor`·eps_phi. The paper says Delta_phi = eps_phi. at_start: the same of the top
/// that is popped at tL since the computed Phi ≤ eps_Phi (Eq. 5b).
std::function<void(Draw&)> delta_phi_is_at_most(int factor, bool at_start = false) {
  return [=](Draw& d) {
    const LinePairs pairs = draw_line_pairs(d);
    suppose(pairs.f.size() >= 2);
    const std::size_t i = d.choose(pairs.f.size() - 1), j = d.choose(pairs.f.size() - 1);
    // Anything near the border of the decision is of interest, the rest is not.
    const Line<double> top = show(d, "top", pairs.f[i]);
    const double slope = pairs.f[j].slope, t = at_start ? pairs.window.lo : pairs.window.hi;
    const Line<double> line{slope, d.nudged(top.at(t) - slope * t, 20)};
    const auto exact = end_form(exact_line(top), exact_line(line), Dyadic::exact(t));
    const Dyadic eps = theorem_4_1_bound(exact.magnitude(), 3);
    const Dyadic sign = Dyadic(at_start ? 1 : -1);
    suppose(sign * Dyadic::exact(end_form(top, line, t).value()) <= eps);
    show(d, "line", line);
    show(d, at_start ? "tL" : "tU", t);
    CLAIM(sign * exact.value() <= Dyadic(factor) * eps);
  };
}

/// A line that is popped since the computed Phi ≤ eps_Phi exceeds its neighbours where they cross
/// by at most 2(|b_alpha − b_(gamma−1)| + |b_gamma − b_(gamma−1)|)[(1 + eps)^4 − 1].
void check_delta_Phi(Draw& d) {
  const auto lines = show(d, "lines", draw_sorted(d, 3, draw_line_pairs(d).f));
  const ExactLines exact = exact_lines(lines);
  const auto phi = product_form(exact[0], exact[1], exact[2]);
  const Dyadic run = phi.p;
  suppose(run.sign() != 0);
  suppose(Dyadic::exact(product_form(lines[0], lines[1], lines[2]).value()) <=
          theorem_4_1_bound(phi.magnitude(), 4));
  // The excess is Phi / run.
  CLAIM(phi.value() <= theorem_4_1_bound((abs(phi.s) + abs(phi.q)).scaled(1), 4) * run);
}

void check_eps_arith(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  const ExactLines kept = exact_lines(selected_lines(ErrorBoundIntended(), pairs.f, pairs.window));
  const ExactLines all = exact_lines(sorted_lines(pairs.f));
  const Dyadic lo = Dyadic::exact(pairs.window.lo), hi = Dyadic::exact(pairs.window.hi);
  const Dyadic bound = eps_arith(all, hi);
  // A line less the maximum of the kept ones is concave: it is greatest at a breakpoint of these.
  for (const Instant& t : breakpoints(kept, lo, hi)) {
    CLAIM(scaled_maximum(all, t) <= scaled_maximum(kept, t) + bound * t.q);
  }
}

/// The lines that Step II takes from the stack.
struct CountingPops : ErrorBoundIntended {
  int* pops;

  explicit CountingPops(int& counter) : pops(&counter) {}
  template <class Predicate>
  bool redundant(const Predicate& predicate) const {
    const bool pop = ErrorBoundIntended::redundant(predicate);
    *pops += pop ? 1 : 0;
    return pop;
  }
};

/// Section 4.4: "each line can be pushed into and popped from the stack at most once", from which
/// the number of lines in Eq. 16 comes.
void check_each_line_once(Draw& d) {
  const LinePairs pairs = show(d, "lines", draw_line_pairs(d));
  int pops = 0;
  const int left =
      show(d, "left", selected_lines(CountingPops(pops), pairs.f, pairs.window).size());
  show(d, "pops", pops);
  CLAIM(pops + left <= static_cast<int>(pairs.f.size()));
}

/// Three lines, the middle one above the crossing of the others by little more than rounding. Their
/// intercepts differ by little, so that the bound is smaller than the rounding of a shift.
std::vector<Line<double>> draw_near_concurrent(Draw& choices) {
  std::vector<Line<double>> lines;
  const double t = std::ldexp(choices.integer(1, 24), -4);
  const double x = choices.integer(-64, 64) / 3.0;
  for (int i = 0; i < 3; ++i) {
    const double slope = std::ldexp(i + choices.integer(-8, 8) / 20.0, -6);
    lines.push_back({slope, choices.nudged(x - slope * t, 3)});
  }
  return lines;
}

/// Each selected line is above its neighbours' crossing: the chain is convex. `raised`: after
/// eps_constr has been added to each intercept.
template <class Policy>
void claim_convex_chain(Draw& d, bool raised) {
  LinePairs pairs = draw_line_pairs(d);
  if (raised) pairs.f = draw_near_concurrent(d);
  const Policy policy;
  const Lines<double> envelope = raised ? envelope_of(policy, pairs.f, pairs.window)
                                        : selected_lines(policy, pairs.f, pairs.window);
  show(d, "lines", pairs);
  show(d, "chain", envelope);
  const ExactLines chain = exact_lines(envelope);
  for (std::size_t i = 2; i < chain.size(); ++i) {
    CLAIM(product_form(chain[i - 2], chain[i - 1], chain[i]).value().sign() > 0);
  }
}

}  // namespace

std::vector<Property> omission_claims() {
  return {
      {"paper.eps_coeff", "Maxima of lines off by eps_a, eps_b differ by at most t^U eps_a + eps_b",
       "Eq. 12", check_eps_coeff},
      {"paper.Delta_phi_as_printed",
       "A line left out at t^U was above the envelope by at most eps_phi", "Section 4.4",
       delta_phi_is_at_most(1), kFails},
      {"paper.Delta_phi", "A line left out at t^U was above the envelope by at most 2 eps_phi",
       "Section 4.4, corrected; Eq. 16 has room for it", delta_phi_is_at_most(2)},
      {"paper.Delta_Phi_at_start",
       "A line popped at t^L was above the envelope by at most 2 eps_Phi",
       "Section 4.4, corrected; Eq. 16 has room for it", delta_phi_is_at_most(2, true)},
      {"paper.Delta_Phi", "A line popped at Phi <= eps_Phi was too high by at most Delta_Phi",
       "Section 4.4, Fig. 2", check_delta_Phi},
      {"paper.eps_arith", "The selected lines are below all lines by at most eps_arith", "Eq. 16",
       check_eps_arith},
      {"paper.each_line_once", "Step II pushes and pops no more lines than there are",
       "Section 4.4", check_each_line_once},
      {"tdibm-e.convex_chain", "The lines selected with Phi <= eps_Phi make a convex chain",
       "Section 4.4, Fig. 2", [](Draw& d) { claim_convex_chain<ErrorBoundIntended>(d, false); }},
      {"tdibm-e.convex_chain_raised",
       "The lines selected with Phi <= eps_Phi still make a convex chain once each is raised by "
       "eps_constr",
       "Section 4.4, which shifts each intercept by itself",
       [](Draw& d) { claim_convex_chain<ErrorBoundIntended>(d, true); }, kFails},
      {"tdibm-e-literal.convex_chain",
       "The lines selected with eps_Phi's sign as printed make a convex chain",
       "Section 4.4 as printed", [](Draw& d) { claim_convex_chain<ErrorBoundPrinted>(d, false); },
       kFails},
  };
}

}  // namespace ccdfuzz
