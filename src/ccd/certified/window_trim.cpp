#include "ccd/certified/window_trim.hpp"

namespace ccdfuzz::certified {

bool trim_by_newton(const NetPair& nets, const Axis& axis, double bound, int sign, bool low_end,
                    Window& w) {
  constexpr int kSteps = 4;
  const int below = sign, above = 1 - sign;
  double t = low_end ? w.hi : w.lo;
  const double end = low_end ? w.lo : w.hi;
  for (int step = 0; step < kSteps; ++step) {
    const SlopedRange b = project_with_slopes(nets.net[below], nets.width[below], axis, t);
    const SlopedRange a = project_with_slopes(nets.net[above], nets.width[above], axis, t);
    const double h = b.max - a.min, slope = b.slope_of_max - a.slope_of_min;
    if (h < -bound) {
      (low_end ? w.lo : w.hi) = t;
      return true;
    }
    // h rises towards the other end, so the tangent there leads back to this one. Aiming half a
    // bound past certainty makes the next evaluation likely to certify.
    if (low_end ? slope <= 0 : slope >= 0) return false;
    t -= (h + 1.5 * bound) / slope;
    if (!(low_end ? t > end : t < end)) return false;
  }
  return false;
}

}  // namespace ccdfuzz::certified
