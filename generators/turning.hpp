#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// Gives a body a spin of up to `most` radians in [0, 1], at most kFastestSpin, about a point in or
/// near it. Its points are turned back from their places, so that they come to them at t, but for a
/// rounding to floats. In a plane, z = 0, it is about the z axis.
void spin_back(MovingPatch<double>& body, double t, bool in_plane, double most, Draw& draw);

}  // namespace ccdfuzz
