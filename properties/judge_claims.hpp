#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the judge says of made-up answers where the truth is known.
std::vector<Property> judge_properties();

}  // namespace ccdfuzz
