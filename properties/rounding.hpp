#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What Section 4.3, Theorem 4.1 and Appendix B say of floating-point errors, each against exact
/// arithmetic on drawn numbers.
std::vector<Property> rounding_properties();

}  // namespace ccdfuzz
