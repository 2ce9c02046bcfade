#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker lets a case say of times at which it touches and does not.
std::vector<Property> case_claim_properties();

}  // namespace ccdfuzz
