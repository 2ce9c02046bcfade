#pragma once

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// The twin family: patch 2 is small and sweeps quickly through patch 1 from below, so that they
/// touch during a short time around t* only. On the normal n of that motion, patch 1's control
/// points make four lines in time. They are the slowest, two that are equal but for a few ulps, and
/// the fastest. The slowest and the fastest together lie above the twins at all times. A method
/// that keeps every line which is not certainly redundant keeps both twins, each for the other's
/// sake (`tdibm-e-literal`). It then takes patch 1 to be below patch 2 too early. t* is a dyadic in
/// (0, 1), t_max = 1.
Scene twin_scene(ContactClass contact, Draw& draw);

}  // namespace ccdfuzz
