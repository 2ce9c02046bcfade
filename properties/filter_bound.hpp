#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// The error of doubles that the filter of tdibm-rational rests on, held to its derivation.
std::vector<Property> filter_bound_properties();

}  // namespace ccdfuzz
