#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Sections 4.4 and 4.5 and Appendix C.1 on the predicates of Steps II and III: that the error of
/// each is within its bound, and that one which is negative beyond it is negative.
std::vector<Property> predicate_properties();

}  // namespace ccdfuzz
