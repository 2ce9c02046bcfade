#pragma once

#include <vector>

#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/exact_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Step II under a policy as TdibmInclusion does it: lines sorted, selected and raised.
/// Requires 1 ≤ lines.size() ≤ kMaxControls, all finite, 0 ≤ lo ≤ hi.
template <class Policy>
Lines<double> envelope_of(const Policy& policy, const std::vector<Line<double>>& lines,
                          const TimeWindow<double>& window) {
  Lines<double> sorted, envelope;
  for (const Line<double>& line : lines) {
    sorted.push_back({line.slope, policy.pulled(line.intercept)});
  }
  sort_lines(sorted);
  upper_envelope(policy, sorted, window, envelope);
  policy.raise(envelope, policy.envelope_error(sorted, CoefficientError{}, window.hi));
  return envelope;
}

/// The maximum of the lines that Step II selects, raised by eps_constr, is nowhere on the window
/// below the exact maximum of all lines. Lines and window are exact inputs.
template <class Policy>
void claim_envelope_is_never_below(const std::vector<Line<double>>& lines,
                                   const TimeWindow<double>& window) {
  const ExactLines all = exact_lines(lines);
  const ExactLines kept = exact_lines(envelope_of(Policy(), lines, window));
  const Dyadic lo = Dyadic::exact(window.lo), hi = Dyadic::exact(window.hi);
  // A line less the maximum of the kept ones is concave: it is greatest at a breakpoint of these.
  for (const Instant& t : breakpoints(kept, lo, hi)) {
    CLAIM(scaled_maximum(all, t) <= scaled_maximum(kept, t));
  }
}

/// Step III under a policy: where it says that max f + max g < 0, that is so in exact arithmetic.
template <class Policy>
void claim_separation_is_true(const LinePairs& pairs) {
  const Policy policy;
  const Lines<double> f = envelope_of(policy, pairs.f, pairs.window);
  const Lines<double> g = envelope_of(policy, pairs.g, pairs.window);
  const auto found = separation(policy, f, g, pairs.window);
  if (!found) return;
  const ExactLines all_f = exact_lines(pairs.f), all_g = exact_lines(pairs.g);
  const auto sign_at = [&](const Dyadic& t) {
    return (maximum(all_f, t) + maximum(all_g, t)).sign();
  };
  // max f + max g is convex: ≤ 0 at both ends and < 0 between them once means < 0 between them.
  const Dyadic lo = Dyadic::exact(found->lo), hi = Dyadic::exact(found->hi);
  CLAIM(sign_at(lo) <= (found->has_lo ? -1 : 0));
  CLAIM(sign_at(hi) <= (found->has_hi ? -1 : 0));
  CLAIM(lo == hi || sign_at((lo + hi).scaled(-1)) < 0);
}

}  // namespace ccdfuzz
