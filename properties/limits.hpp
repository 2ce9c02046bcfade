#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What a case file may ask of its reader and of the checker: limits that honest files do not meet.
std::vector<Property> limit_properties();

}  // namespace ccdfuzz
