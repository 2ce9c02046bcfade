#pragma once

#include <optional>

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Steps I to IV as the paper has them: parameters, two random patches in (tangential) contact, the
/// static check, local parts of them, velocities. nullopt if the static check discards it. Nothing
/// is known yet of the time before t*.
/// Every number is a multiple of 2^-41 below 2^11, which a double holds.
/// grazing: the contact points' relative velocity lies in the contact plane.
std::optional<Scene> paper_scene(ContactClass contact, bool grazing, Draw& draw);

}  // namespace ccdfuzz
