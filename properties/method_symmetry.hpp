#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What changes of a query that keep its contact do to the answers of methods.
std::vector<Property> method_symmetry_properties();

}  // namespace ccdfuzz
