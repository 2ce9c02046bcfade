#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// Every property, for drivers and for `ccdfuzz properties`.
const std::vector<Property>& properties();

/// Errors: an unknown name, with those that are like it.
Result<Property> property_named(std::string_view name,
                                const std::vector<Property>& among = properties());

}  // namespace ccdfuzz
