#pragma once

#include <vector>

#include "ccd/separation.hpp"
#include "properties/draw_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Step II under a policy: the maximum of the lines that it selects, raised by eps_constr, is
/// nowhere on the window below the exact maximum of all lines. Lines and window are exact inputs.
/// Requires 1 ≤ lines.size() ≤ kMaxControls, all finite, 0 ≤ lo ≤ hi.
template <class Policy>
Check envelope_is_never_below_the_maximum(const Policy& policy,
                                          const std::vector<Line<double>>& lines,
                                          const TimeWindow<double>& window);

/// Step III under a policy: where it says that max f + max g < 0, that is so in exact arithmetic.
template <class Policy>
Check separation_is_true(const Policy& policy, const LinePairs& pairs);

/// Step III under a policy: an end that it finds inside of the window is the root of two lines
/// whose sum falls there (the start) or rises (the end), however rounding misleads it.
template <class Policy>
Check ends_are_of_their_side(const Policy& policy, const LinePairs& pairs);

template <class Policy>
Check check_envelope(Draw& choices) {
  const LinePairs pairs = draw_line_pairs(choices);
  return envelope_is_never_below_the_maximum(Policy(), pairs.f, pairs.window);
}

template <class Policy>
Check check_separation(Draw& choices) {
  return separation_is_true(Policy(), draw_line_pairs(choices));
}

template <class Policy>
Check check_ends(Draw& choices) {
  return ends_are_of_their_side(Policy(), draw_touching_pairs(choices));
}

/// These claims of each of the methods.
std::vector<Property> envelope_properties();

}  // namespace ccdfuzz
