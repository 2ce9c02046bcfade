#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Going to exact numbers and back loses nothing: for x as Dyadic and as Rational, and Dyadic
/// arithmetic agrees with Rational on x, y.
void claim_dyadic_round_trip(double x, double y);

}  // namespace ccdfuzz
