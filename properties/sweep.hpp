#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What Section 4.5 and Appendix C.3 say of the sweep of Step III from the left: Eq. 18, the path
/// of pairs of lines, and what wrong judgements of Eqs. 7, 8b and 9b lead to.
std::vector<Property> sweep_properties();

}  // namespace ccdfuzz
