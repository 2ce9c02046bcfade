#include "ccd/certified/window_trim.hpp"

#include <algorithm>
#include <limits>

namespace ccdfuzz::certified {

HeightLines::HeightLines(const NetPair& nets, const Axis& axis) {
  for (int s = 0; s < 2; ++s) {
    counts_[s] = nets.count[s];
    const double* p = nets.net[s];
    for (int i = 0; i < nets.count[s]; ++i, p += kPerPoint) {
      intercepts_[s][i] = (p[0] * axis[0] + p[1] * axis[1]) + p[2] * axis[2];
      slopes_[s][i] = (p[4] * axis[0] + p[5] * axis[1]) + p[6] * axis[2];
      if (const double weight = p[kWeightPlace]; weight != 0) {
        intercepts_[s][i] /= weight;
        slopes_[s][i] /= weight;
      }
    }
  }
}

Range HeightLines::extent(int side, double t) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Range out{kInfinity, -kInfinity};
  for (int i = 0; i < counts_[side]; ++i) {
    const double height = slopes_[side][i] * t + intercepts_[side][i];
    out = {std::min(out.min, height), std::max(out.max, height)};
  }
  return out;
}

HeightLines::Gap HeightLines::gap(int below, double t) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double most = -kInfinity, least = kInfinity, slope_of_most = 0, slope_of_least = 0;
  for (int i = 0; i < counts_[below]; ++i) {
    const double slope = slopes_[below][i], height = slope * t + intercepts_[below][i];
    if (height > most) most = height, slope_of_most = slope;
  }
  for (int i = 0; i < counts_[1 - below]; ++i) {
    const double slope = slopes_[1 - below][i], height = slope * t + intercepts_[1 - below][i];
    if (height < least) least = height, slope_of_least = slope;
  }
  return {most - least, slope_of_most - slope_of_least};
}

bool trim_by_newton(const HeightLines& lines, double bound, int sign, bool low_end,
                    const Window& seen, Window& w) {
  constexpr int kSteps = 4;
  double t = low_end ? seen.hi : seen.lo;
  const double end = low_end ? seen.lo : seen.hi;
  for (int step = 0; step < kSteps; ++step) {
    const HeightLines::Gap gap = lines.gap(sign, t);
    if (gap.height < -bound) {
      CCDFUZZ_ASSERT(lines.extent(sign, t).max - lines.extent(1 - sign, t).min < -bound);
      CCDFUZZ_ASSERT(seen.lo <= t && t <= seen.hi);
      if (low_end) {
        w.lo = std::max(w.lo, t);
      } else {
        w.hi = std::min(w.hi, t);
      }
      return true;
    }
    // h rises towards the other end, so the tangent there leads back to this one. Aiming half a
    // bound past certainty makes the next evaluation likely to certify.
    if (low_end ? gap.slope <= 0 : gap.slope >= 0) return false;
    t -= (gap.height + 1.5 * bound) / gap.slope;
    if (!(low_end ? t > end : t < end)) return false;
  }
  return false;
}

}  // namespace ccdfuzz::certified
