#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker makes of certificates that are wrong, or no certificates at all.
std::vector<Property> spoilt_certificate_properties();

}  // namespace ccdfuzz
