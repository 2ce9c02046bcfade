#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What tdibm-c makes of the windows of pairs of cells. A window that is longer than it could be
/// loses no contact; it costs boxes, and makes answers early.
std::vector<Property> pair_window_properties();

}  // namespace ccdfuzz
