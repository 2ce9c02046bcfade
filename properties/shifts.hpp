#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What TDIBM-E adds to envelopes and roots, against the equations that it comes from in exact
/// arithmetic: a bound that is too small need not lose a contact that anybody draws.
std::vector<Property> shift_properties();

}  // namespace ccdfuzz
