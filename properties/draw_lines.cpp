#include "properties/draw_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

constexpr int kUlps = 4;  // how near is "almost equal"
constexpr std::int64_t kMostLines = 10;

/// In (−2^4, 2^4): a quarter of an integer, or that and 53 bits.
double draw_number(Draw& choices) {
  const double quarters = std::ldexp(choices.integer(-63, 63), -2);
  if (!choices.coin()) return quarters;
  constexpr std::int64_t kBits = std::int64_t{1} << 53;
  return quarters + std::ldexp(choices.integer(1 - kBits, kBits - 1), -55);
}

std::vector<Line<double>> draw_lines(Draw& choices, double through_t, double through_x) {
  // Concurrent lines are hard for the predicates, and twins hide what lies behind them. Together
  // they disturb each other, so there are lists of one sort as well as mixed ones.
  const std::uint64_t sort = choices.choose(2);
  const bool concurrent = sort != 1, twins = sort != 0;
  std::vector<Line<double>> lines;
  for (std::int64_t n = choices.integer(1, kMostLines); n > 0; --n) {
    const bool on_its_own = !choices.coin();
    if (twins && !on_its_own && !lines.empty()) {
      const Line<double> other = lines[choices.choose(lines.size() - 1)];
      const double slope = choices.nudged(other.slope, kUlps);
      const double intercept = choices.nudged(other.intercept, kUlps);
      lines.push_back({slope, intercept});
    } else if (concurrent && on_its_own) {
      const double slope = draw_number(choices);
      const double intercept = choices.nudged(through_x - slope * through_t, kUlps);
      lines.push_back({slope, intercept});
    } else {
      const double slope = draw_number(choices);
      const double intercept = draw_number(choices);
      lines.push_back({slope, intercept});
    }
  }
  return lines;
}

double greatest_at(const std::vector<Line<double>>& lines, double t) {
  double greatest = lines.front().at(t);
  for (const Line<double>& line : lines) greatest = std::max(greatest, line.at(t));
  return greatest;
}

}  // namespace

LinePairs draw_line_pairs(Draw& choices) {
  constexpr std::int64_t kEighths = 32;
  const std::int64_t begin = choices.integer(0, kEighths);
  const std::int64_t end = choices.integer(begin, kEighths);
  LinePairs pairs;
  pairs.window = {std::ldexp(static_cast<double>(begin), -3),
                  std::ldexp(static_cast<double>(end), -3)};
  const double t = choices.nudged(std::ldexp(choices.integer(0, 96), -5), 1);
  const double x = draw_number(choices);
  pairs.f = draw_lines(choices, t, x);
  pairs.g = draw_lines(choices, t, -x);
  if (choices.coin()) {
    const double gap = greatest_at(pairs.f, t) + greatest_at(pairs.g, t);
    for (Line<double>& line : pairs.g) line.intercept -= gap;
  }
  return pairs;
}

LinePairs draw_touching_pairs(Draw& choices) {
  LinePairs pairs = draw_line_pairs(choices);
  if (choices.coin()) return pairs;
  pairs.g.clear();
  for (const Line<double>& line : pairs.f) {
    const double slope = choices.nudged(-line.slope, kUlps);
    const double intercept = choices.nudged(-line.intercept, kUlps);
    pairs.g.push_back({slope, intercept});
  }
  return pairs;
}

std::vector<Line<double>> draw_sorted(Draw& choices, std::size_t count,
                                      const std::vector<Line<double>>& from) {
  if (from.size() < count) throw Discarded();
  const Lines<double> sorted = sorted_lines(from);
  const auto first = static_cast<int>(choices.choose(from.size() - count));
  return {sorted.begin() + first, sorted.begin() + first + static_cast<int>(count)};
}

Lines<double> sorted_lines(const std::vector<Line<double>>& lines) {
  Lines<double> sorted;
  for (const Line<double>& line : lines) sorted.push_back(line);
  sort_lines(sorted);
  return sorted;
}

std::string to_hex_text(const Line<double>& line) {
  return fmt::format("({}, {})", to_hex(line.slope), to_hex(line.intercept));
}

std::string to_hex_text(const TimeWindow<double>& window) {
  return fmt::format("[{}, {}]", to_hex(window.lo), to_hex(window.hi));
}

std::string to_hex_text(const LinePairs& pairs) {
  return fmt::format("f {} g {} on {}", shown(pairs.f), shown(pairs.g), to_hex_text(pairs.window));
}

}  // namespace ccdfuzz
