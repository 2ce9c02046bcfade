#pragma once

#include "generators/draw/draw.hpp"
#include "generators/similar.hpp"

namespace ccdfuzz {

/// Moves all positions by a little and all ends by much, as far as their bits allow. So differences
/// of the two have more bits. nullopt if they have no room.
std::optional<Case> parted(const Case& value, Draw& draw);

}  // namespace ccdfuzz
