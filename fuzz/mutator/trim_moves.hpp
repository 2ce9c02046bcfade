#pragma once

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Gives a patch a loop about its contact; or takes or adds a loop or a vertex, or moves a vertex
/// to the next double. False if the loops were none that a patch may have, or the contact left
/// them.
bool change_trim(Contact& q, Draw& draw);

}  // namespace ccdfuzz
