#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker's decision "this polynomial is ≥ 0 all over its domain" says and does not say.
std::vector<Property> polynomial_properties();

}  // namespace ccdfuzz
