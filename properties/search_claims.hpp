#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What methods promise of budgets, of long time steps, and of how early a hit may be.
std::vector<Property> search_properties();

}  // namespace ccdfuzz
