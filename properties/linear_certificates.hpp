#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker refuses of certificates about linear queries, held against the exact first
/// contact, which shares no code with it.
std::vector<Property> linear_certificate_properties();

}  // namespace ccdfuzz
