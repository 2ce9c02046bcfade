#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// The readers of what is not the case format: query CSV, and the lines that plug-ins answer.
std::vector<Property> outside_data_properties();

}  // namespace ccdfuzz
