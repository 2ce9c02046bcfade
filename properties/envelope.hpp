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

}  // namespace ccdfuzz
