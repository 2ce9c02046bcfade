#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ccdfuzz::certified {

/// Where in [0, 1) a polynomial with these coefficients, of powers from 0 up, may have a root. The
/// guess is by the chord, then by Newton's steps. A step that would leave the interval halves it
/// instead. Requires that the signs at both ends differ. No law needs the guess: a bad one costs
/// time alone.
inline double guess_root(const std::array<double, 4>& c) {
  constexpr int kSteps = 12;
  /// A step of Newton's leaves an error about the square of its length.
  constexpr double kLastStep = 0x1p-26;
  const auto value = [&c](double x) { return c[0] + x * (c[1] + x * (c[2] + x * c[3])); };
  const double at_1 = value(1);
  const bool rises = at_1 > 0;
  const double chord = c[0] / (c[0] - at_1);
  double lo = 0, hi = 1, x = 0 < chord && chord < 1 ? chord : 0.5;
  for (int i = 0; i < kSteps; ++i) {
    const double y = value(x);
    ((y < 0) == rises ? lo : hi) = x;
    const double next = x - y / (c[1] + x * (2 * c[2] + x * 3 * c[3]));
    const double before = std::exchange(x, lo < next && next < hi ? next : 0.5 * (lo + hi));
    if (std::abs(x - before) <= kLastStep) break;
  }
  return std::min(x, 1 - 0x1p-53);
}

}  // namespace ccdfuzz::certified
