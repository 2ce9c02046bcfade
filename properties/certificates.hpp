#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker and the generators' plane must refuse: certificates and scenes in which one
/// thing was changed so that nothing is proven any more.
std::vector<Property> certificate_properties();

}  // namespace ccdfuzz
