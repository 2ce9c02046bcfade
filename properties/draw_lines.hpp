#pragma once

#include <array>
#include <vector>

#include "ccd/envelope.hpp"
#include "ccd/line.hpp"
#include "ccd/time_interval.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The lines of two patches on one axis: f of patch 1, g of patch 2 negated. The axis separates the
/// patches, patch 1 below patch 2, where max f + max g < 0.
struct LinePairs {
  std::vector<Line<double>> f;
  std::vector<Line<double>> g;
  TimeWindow<double> window;
};

/// Lines that are hard to order: some concurrent, some twins of each other, both up to a few
/// floats, and others between them. Often max f + max g is about 0 at some time of the window. 1 to
/// 10 lines a side. Slopes and intercepts are 0 or between 2^-60 and 2^9, so that no product of two
/// of them underflows; 0 ≤ window.lo ≤ window.hi ≤ 4.
LinePairs draw_line_pairs(Draw& choices);

/// The same, or half of the time g is f itself up to a few floats. Then max f + max g is about 0
/// wherever all lines of f meet, and rises and falls by next to nothing there.
LinePairs draw_touching_pairs(Draw& choices);

/// `count` of the lines by rising slope, in turn from a drawn place; discarded if there are fewer.
std::vector<Line<double>> draw_sorted(Draw& choices, std::size_t count,
                                      const std::vector<Line<double>>& from);

/// As Step II takes them: by rising slope. At most kMaxControls.
Lines<double> sorted_lines(const std::vector<Line<double>>& lines);

/// As Step II selects them.
template <class Policy>
Lines<double> selected_lines(const Policy& policy, const std::vector<Line<double>>& lines,
                             const TimeWindow<double>& window) {
  Lines<double> envelope;
  upper_envelope(policy, sorted_lines(lines), window, envelope);
  return envelope;
}
/// Those of f and of g.
template <class Policy>
std::array<Lines<double>, 2> selected_lines(const Policy& policy, const LinePairs& pairs) {
  return {selected_lines(policy, pairs.f, pairs.window),
          selected_lines(policy, pairs.g, pairs.window)};
}

/// For failure texts.
std::string to_hex_text(const Line<double>& line);
std::string to_hex_text(const TimeWindow<double>& window);
std::string to_hex_text(const LinePairs& pairs);

}  // namespace ccdfuzz
