#pragma once

#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// What the checker accepts and refuses of trees of separating axes.
std::vector<Property> miss_tree_properties();

}  // namespace ccdfuzz
