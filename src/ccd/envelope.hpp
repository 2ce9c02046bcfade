#pragma once

#include "ccd/robustness.hpp"

namespace ccdfuzz {

/// Upper envelope on w (Step II, Eqs. 5–6): the lines that are the maximum somewhere, in the order
/// of time. Requires sorted lines, at least one, finite, and w.lo ≤ w.hi. A window may
/// begin before 0 (Reading::window_margin), but not where lines are raised by envelope_error.
/// A lower envelope is the negated upper envelope of the negated lines, so there is no other code.
/// Safe, for exact S: equal to the maximum everywhere on w. For double it is what Policy makes it;
/// its lines are among those given. ErrorBound claims that raising them by envelope_error leaves it
/// nowhere below the exact maximum.
template <class Policy, class S>
void upper_envelope(const Policy& policy, const Lines<S>& sorted, const TimeWindow<S>& w,
                    Lines<S>& envelope) {
  envelope.clear();
  for (int next = 0; next < sorted.size(); ++next) {
    const Line<S>* line = &sorted[next];
    // Only the highest of lines with equal slopes counts.
    for (; next + 1 < sorted.size() && sorted[next + 1].slope == line->slope; ++next) {
      if (line->intercept <= sorted[next + 1].intercept) line = &sorted[next + 1];
    }
    while (envelope.size() >= 2) {
      const Line<S>&top = envelope.back(), &below = envelope[envelope.size() - 2];
      const ProductDifference<S> phi{S(line->slope - below.slope),
                                     S(top.intercept - below.intercept), S(top.slope - below.slope),
                                     S(line->intercept - below.intercept)};  // Eq. 5a
      if (!policy.redundant(phi)) break;
      envelope.pop_back();
    }
    const auto top_minus_line_at = [&](const S& t) {
      const Line<S>& top = envelope.back();
      return EndValue<S>{S(top.slope - line->slope), S(top.intercept - line->intercept), t};
    };
    if (envelope.size() == 1 && policy.redundant(top_minus_line_at(w.lo))) {  // Eq. 5b
      envelope.pop_back();
    }
    if (envelope.empty() || policy.negative(top_minus_line_at(w.hi))) {  // Eq. 6
      envelope.push_back(*line);
    }
  }
}

}  // namespace ccdfuzz
