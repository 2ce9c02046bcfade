#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// Appendix A, the errors of Step I: of control points of sub-patches, of axes, of slopes and
/// intercepts, each against exact arithmetic.
std::vector<Property> coefficient_properties();

}  // namespace ccdfuzz
