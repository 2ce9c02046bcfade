#include <fmt/format.h>

#include "ccd/envelope.hpp"
#include "properties/draw_lines.hpp"
#include "properties/error_bound.hpp"
#include "properties/exact_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

namespace {

Check failure(const LinePairs& pairs, const std::string& what) {
  return Check::fails(
      fmt::format("lines {} on {}: {}", to_hex_text(pairs.f), to_hex_text(pairs.window), what));
}

/// Eq. 12: maxima of lines that differ by at most eps_a, eps_b differ by at most tU·eps_a + eps_b.
Check check_eps_coeff(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  ExactLines exact = exact_lines(pairs.f), off;
  const Dyadic eps_a = choices.dyadic(8, -40), eps_b = choices.dyadic(8, -40);
  for (const Line<Dyadic>& line : exact) {
    const auto share = [&] { return choices.dyadic(4, -4); };  // in (−1, 1)
    const Dyadic slope = line.slope + eps_a * share();
    const Dyadic intercept = line.intercept + eps_b * share();
    off.push_back({slope, intercept});
  }
  const Dyadic hi = Dyadic::exact(pairs.window.hi), lo = Dyadic::exact(pairs.window.lo);
  const Dyadic bound = hi * abs(eps_a) + abs(eps_b);
  // The difference of the two maxima is linear between the breakpoints of both.
  for (const ExactLines& turning : {exact, off}) {
    for (const Instant& t : breakpoints(turning, lo, hi)) {
      if (bound * t.q < abs(scaled_maximum(off, t) - scaled_maximum(exact, t))) {
        return failure(pairs, "at t = " + to_text(t));
      }
    }
  }
  return Check::holds();
}

/// A line that is not pushed since the computed phi ≥ −eps_phi is above the top of the stack at tU
/// by at most `factor`·eps_phi. The paper says Delta_phi = eps_phi.
Check delta_phi_is_at_most(Draw& choices, int factor) {
  const LinePairs pairs = draw_line_pairs(choices);
  if (pairs.f.size() < 2) return Check::discarded("fewer than two lines");
  const std::size_t i = choices.choose(pairs.f.size() - 1), j = choices.choose(pairs.f.size() - 1);
  // Anything near the border of the decision is of interest, the rest is not.
  const Line<double> top = pairs.f[i];
  const double slope = pairs.f[j].slope, t = pairs.window.hi;
  const double intercept = choices.nudged(top.at(t) - slope * t, 20);
  const EndValue<double> phi{top.slope - slope, top.intercept - intercept, t};
  const EndValue<Dyadic> exact{Dyadic::exact(top.slope) - Dyadic::exact(slope),
                               Dyadic::exact(top.intercept) - Dyadic::exact(intercept),
                               Dyadic::exact(t)};
  const Dyadic eps = theorem_4_1_bound(exact.magnitude(), 3);
  if (Dyadic::exact(phi.value()) < -eps) return Check::discarded("it is pushed");
  if (-exact.value() <= Dyadic(factor) * eps) return Check::holds();
  return Check::fails(fmt::format("top ({}, {}), line ({}, {}), tU = {}: above by more than {} eps",
                                  to_hex(top.slope), to_hex(top.intercept), to_hex(slope),
                                  to_hex(intercept), to_hex(t), factor));
}

/// A line that is popped since the computed Phi ≤ eps_Phi exceeds its neighbours where they cross
/// by at most 2(|b_alpha − b_(gamma−1)| + |b_gamma − b_(gamma−1)|)[(1 + eps)^4 − 1].
Check check_delta_Phi(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  const Lines<double> sorted = sorted_lines(pairs.f);
  if (sorted.size() < 3) return Check::discarded("fewer than three lines");
  const auto first =
      static_cast<int>(choices.choose(static_cast<std::uint64_t>(sorted.size() - 3)));
  const Line<double>&below = sorted[first], &top = sorted[first + 1], &line = sorted[first + 2];
  const Line<Dyadic> below_x = exact_line(below), top_x = exact_line(top),
                     line_x = exact_line(line);
  const Dyadic run = line_x.slope - below_x.slope;
  if (run.sign() == 0) return Check::discarded("equal slopes");
  const ProductDifference<double> phi{line.slope - below.slope, top.intercept - below.intercept,
                                      top.slope - below.slope, line.intercept - below.intercept};
  const ProductDifference<Dyadic> exact{run, top_x.intercept - below_x.intercept,
                                        top_x.slope - below_x.slope,
                                        line_x.intercept - below_x.intercept};
  if (theorem_4_1_bound(exact.magnitude(), 4) < Dyadic::exact(phi.value())) {
    return Check::discarded("it stays");
  }
  // The excess is Phi / run.
  const Dyadic most = theorem_4_1_bound((abs(exact.s) + abs(exact.q)).scaled(1), 4) * run;
  return exact.value() <= most ? Check::holds() : failure(pairs, "the popped line is too high");
}

Lines<double> selected(const LinePairs& pairs, const auto& policy, Lines<double>& sorted) {
  Lines<double> envelope;
  sorted = sorted_lines(pairs.f);
  upper_envelope(policy, sorted, pairs.window, envelope);
  return envelope;
}

/// Eq. 16: the maximum of the selected lines is below that of all by at most eps_arith.
Check check_eps_arith(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  Lines<double> sorted;
  const ExactLines kept = exact_lines(selected(pairs, ErrorBoundIntended(), sorted));
  const ExactLines all = exact_lines(sorted);
  const Dyadic lo = Dyadic::exact(pairs.window.lo), hi = Dyadic::exact(pairs.window.hi);
  const Dyadic bound = eps_arith(all, hi);
  // A line less the maximum of the kept ones is concave: it is greatest at a breakpoint of these.
  for (const Instant& t : breakpoints(kept, lo, hi)) {
    if (scaled_maximum(kept, t) + bound * t.q < scaled_maximum(all, t)) {
      return failure(pairs, "at t = " + to_text(t));
    }
  }
  return Check::holds();
}

/// Eq. 13, its second inequality, of three lines by rising slope: both terms of B are at most
/// a_alpha − a_(gamma−1) times the difference of intercepts in them.
Check check_eq_13_second(Draw& choices) {
  const ExactLines sorted = exact_lines(sorted_lines(draw_line_pairs(choices).f));
  if (sorted.size() < 3) return Check::discarded("fewer than three lines");
  const std::size_t first = choices.choose(sorted.size() - 3);
  const Line<Dyadic>&below = sorted[first], &top = sorted[first + 1], &line = sorted[first + 2];
  const Dyadic run = line.slope - below.slope, to_line = abs(line.intercept - below.intercept),
               to_top = abs(top.intercept - below.intercept);
  if (abs(top.slope - below.slope) * to_line + abs(run) * to_top <= run * (to_line + to_top)) {
    return Check::holds();
  }
  return Check::fails(fmt::format("lines {} to {} of those drawn, by slope", first, first + 2));
}

/// What Step II takes from the stack.
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
Check check_each_line_once(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  int pops = 0;
  Lines<double> sorted;
  const int left = selected(pairs, CountingPops(pops), sorted).size();
  return pops + left <= sorted.size()
             ? Check::holds()
             : failure(pairs, fmt::format("{} popped, {} left", pops, left));
}

/// Three lines, the middle one above the crossing of the others by little more than rounding; their
/// intercepts differ by little, so that the bound is small against the rounding of a shift.
std::vector<Line<double>> draw_near_concurrent(Draw& choices) {
  std::vector<Line<double>> lines;
  const double t = std::ldexp(static_cast<double>(choices.integer(1, 24)), -4);
  const double x = static_cast<double>(choices.integer(-64, 64)) / 3;
  for (int i = 0; i < 3; ++i) {
    const double slope = std::ldexp(i + static_cast<double>(choices.integer(-8, 8)) / 20, -6);
    lines.push_back({slope, choices.nudged(x - slope * t, 3)});
  }
  return lines;
}

/// Each selected line is above its neighbours' crossing: the chain is convex. `raised`: after
/// eps_constr has been added to each intercept.
template <class Policy>
Check chain_is_convex(Draw& choices, bool raised) {
  LinePairs pairs = draw_line_pairs(choices);
  if (raised) pairs.f = draw_near_concurrent(choices);
  const Policy policy;
  Lines<double> sorted;
  Lines<double> envelope = selected(pairs, policy, sorted);
  if (raised) policy.raise(envelope, policy.envelope_error(sorted, {}, pairs.window.hi));
  const ExactLines chain = exact_lines(envelope);
  for (std::size_t i = 2; i < chain.size(); ++i) {
    const Line<Dyadic>&below = chain[i - 2], &top = chain[i - 1], &line = chain[i];
    const ProductDifference<Dyadic> phi{line.slope - below.slope, top.intercept - below.intercept,
                                        top.slope - below.slope, line.intercept - below.intercept};
    if (phi.value().sign() <= 0) {
      return failure(pairs, fmt::format("line {} of the chain is nowhere the maximum", i - 1));
    }
  }
  return Check::holds();
}

}  // namespace

std::vector<Property> omission_claims() {
  constexpr auto kHolds = Expectation::kHolds, kFails = Expectation::kFails;
  return {
      {"paper.eps_coeff", "Maxima of lines off by eps_a, eps_b differ by at most t^U eps_a + eps_b",
       "Eq. 12", kHolds, check_eps_coeff},
      {"paper.Delta_phi_as_printed",
       "A line left out at t^U was above the envelope by at most eps_phi", "Section 4.4", kFails,
       [](Draw& c) { return delta_phi_is_at_most(c, 1); }},
      {"paper.Delta_phi", "A line left out at t^U was above the envelope by at most 2 eps_phi",
       "Section 4.4, corrected; Eq. 16 has room for it", kHolds,
       [](Draw& c) { return delta_phi_is_at_most(c, 2); }},
      {"paper.Delta_Phi", "A line popped at Phi <= eps_Phi was too high by at most Delta_Phi",
       "Section 4.4, Fig. 2", kHolds, check_delta_Phi},
      {"paper.eps_arith", "The selected lines are below all lines by at most eps_arith", "Eq. 16",
       kHolds, check_eps_arith},
      {"paper.eq_13_second",
       "eps_Phi is at most (a_alpha - a_(gamma-1)) times the differences of intercepts", "Eq. 13",
       kHolds, check_eq_13_second},
      {"paper.each_line_once", "Step II pushes and pops no more lines than there are",
       "Section 4.4", kHolds, check_each_line_once},
      {"tdibm-e.convex_chain", "The lines selected with Phi <= eps_Phi make a convex chain",
       "Section 4.4, Fig. 2", kHolds,
       [](Draw& c) { return chain_is_convex<ErrorBoundIntended>(c, false); }},
      {"tdibm-e.convex_chain_raised", "They still do once each is raised by eps_constr",
       "Section 4.4, which shifts each intercept by itself", kFails,
       [](Draw& c) { return chain_is_convex<ErrorBoundIntended>(c, true); }},
      {"tdibm-e-literal.convex_chain", "The lines selected with eps_Phi's sign as printed do",
       "Section 4.4 as printed", kFails,
       [](Draw& c) { return chain_is_convex<ErrorBoundPrinted>(c, false); }},
  };
}

}  // namespace ccdfuzz
