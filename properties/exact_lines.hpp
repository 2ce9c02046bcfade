#pragma once

#include <vector>

#include "ccd/line.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

using ExactLines = std::vector<Line<Dyadic>>;

inline Line<Dyadic> exact_line(const Line<double>& line) {
  return {Dyadic::exact(line.slope), Dyadic::exact(line.intercept)};
}

/// The same lines in exact numbers, from any list of them.
template <class List>
ExactLines exact_lines(const List& lines) {
  ExactLines out;
  for (const Line<double>& line : lines) out.push_back(exact_line(line));
  return out;
}

inline Dyadic maximum(const ExactLines& lines, const Dyadic& t) {
  Dyadic greatest = lines.front().at(t);
  for (const Line<Dyadic>& line : lines) {
    const Dyadic value = line.at(t);
    if (greatest < value) greatest = value;
  }
  return greatest;
}

}  // namespace ccdfuzz
