#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Eqs. 7 to 9, in the order and the rounded arithmetic in which the paper has them.
std::vector<Property> step_three_properties();

}  // namespace ccdfuzz
