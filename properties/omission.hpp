#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Section 4.4 on what Step II loses when it leaves out a line or keeps one too many: eps_coeff,
/// Delta_phi, Delta_Phi, eps_arith, and whether the chain stays convex.
std::vector<Property> omission_properties();

}  // namespace ccdfuzz
