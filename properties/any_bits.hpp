#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What methods make of queries and options of any bits.
std::vector<Property> any_bits_properties();

}  // namespace ccdfuzz
