#pragma once

#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The points of a body at time t, which turns or does not. They have a common divisor > 0, as
/// points that are divided one by one take a gcd for each coordinate.
struct PointsAt {
  Points<Fraction> dividends;
  Fraction divisor = 1;
  /// False where a body spins, or turns by cosine and sine and |q| is not rational. Then the points
  /// are within about 2^-96 of their distance from the centre.
  bool are_exact = true;

  Points<Rational> rational() const;
  /// Coordinates in units, rounded down to whole ones.
  Points<Integer> in_units(const Fraction& unit) const;
};
PointsAt points_at(const MovingPatch<double>& body, const Rational& t);

}  // namespace ccdfuzz
