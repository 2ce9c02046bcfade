#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// Gives a body a spin of up to 3 radians in [0, 1], or of π/4 if it is small, about a point in or
/// near it. Its points are turned back from their places, so that they come to them at t, but for a
/// rounding to floats. In a plane, z = 0, it is about the z axis.
void spin_back(MovingPatch<double>& body, double t, bool in_plane, bool is_small, Draw& draw);

}  // namespace ccdfuzz
