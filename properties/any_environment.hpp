#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What judges and certifies says the same, to the bit, in every floating-point environment that a
/// host program may leave to the thread (fp_environment.hpp).
std::vector<Property> any_environment_properties();

}  // namespace ccdfuzz
