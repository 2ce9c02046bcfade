#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Every property, for drivers and for `ccdfuzz properties`.
const std::vector<Property>& properties();

/// Errors: an unknown name, with the names that there are.
Result<Property> property_named(std::string_view name,
                                const std::vector<Property>& among = properties());

}  // namespace ccdfuzz
