#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Witness tracing as a claim: no pair of boxes that holds a contact is dropped on the way, and
/// its window never loses the time of contact.
std::vector<Property> traced_properties();

}  // namespace ccdfuzz
