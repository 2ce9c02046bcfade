#pragma once

#include <array>

#include "bezier/patch.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// The points of a body at time t, which turns or does not.
struct PointsAt {
  Points<Rational> points;
  /// False where a body spins, or turns by cosine and sine and |q| is not rational. Then the points
  /// are within about 2^-96 of their distance from the centre.
  bool are_exact = true;
};
PointsAt points_at(const MovingPatch<double>& body, const Rational& t);

}  // namespace ccdfuzz
