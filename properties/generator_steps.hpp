#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the steps of the inverse construction promise (Section 5), each in exact numbers.
std::vector<Property> generator_properties();

}  // namespace ccdfuzz
