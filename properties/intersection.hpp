#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Eqs. 3, 4, 10 and 18 and Appendix C: where two patches overlap on an axis, and how the ends of
/// the separated interval are found.
std::vector<Property> intersection_properties();

}  // namespace ccdfuzz
