#pragma once

#include "generators/generate.hpp"
#include "generators/random.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// A scene of a stress family; not kRegular.
Scene stress_scene(Family family, ContactClass contact, Random& random);

}  // namespace ccdfuzz
