#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// The number types against GMP, and the texts and bits that numbers become.
std::vector<Property> arithmetic_properties();

}  // namespace ccdfuzz
