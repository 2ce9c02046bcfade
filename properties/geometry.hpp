#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What every method takes for granted of Bézier patches and their subdivision, in exact numbers.
std::vector<Property> geometry_properties();

}  // namespace ccdfuzz
