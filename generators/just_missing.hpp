#pragma once

#include "generators/attempts.hpp"

namespace ccdfuzz {

/// The near miss of two bodies that move along the plane between them, of a normal that the case's
/// certificate K has. One of the two is moved away along it by the shortest step in floats of their
/// size. That is a power of two times the normal without its common factor. It is the last place of
/// the largest coordinate, or more where a coordinate would be no float. Turns about the normal
/// stay as they are. The truth is the oracle's. Thrown away is what has no step shorter than the
/// largest coordinate, or is not proven to miss.
Attempted just_missing(Case grazing, Draw& draw);

}  // namespace ccdfuzz
