#include "generators/similar.hpp"

#include <cmath>

namespace ccdfuzz {

namespace {

/// Adds b to a; false if the sum is rounded.
bool add_exactly(double& a, double b) {
  const double sum = a + b, part = sum - a;
  // What rounding took from either summand (Knuth's two-sum): exact unless the sum overflows.
  const double error = (a - (sum - part)) + (b - part);
  a = sum;
  return std::isfinite(sum) && error == 0;
}

/// Multiplies a by 2^exponent; false if the product is rounded.
bool scale_exactly(double& a, int exponent) {
  const double scaled = std::ldexp(a, exponent);
  const bool exact = std::isfinite(scaled) && std::ldexp(scaled, -exponent) == a;
  a = scaled;
  return exact;
}

bool change_points(Points<double>& points, const Vec3<double>& by, int exponent) {
  for (Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) {
      if (!add_exactly(p[k], by[k]) || !scale_exactly(p[k], exponent)) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<Case> similar(const Case& value, const Similarity& change) {
  Case out = value;
  for (MovingPatch<double>& patch : out.query.patches) {
    if (!change_points(patch.positions, change.shift, change.space) ||
        !change_points(patch.velocities, change.drift, change.space - change.time)) {
      return std::nullopt;
    }
  }
  if (!scale_exactly(out.query.t_max, change.time)) return std::nullopt;
  const Rational unit = power_of_two(change.time);
  if (out.truth.witness) out.truth.witness->t *= unit;
  if (out.truth.clear_until) *out.truth.clear_until *= unit;
  out.expect.clear();
  return out;
}

}  // namespace ccdfuzz
