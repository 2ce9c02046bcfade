#pragma once

#include "properties/property.hpp"

namespace ccdfuzz {

/// What every method's answers have in common, whatever they say, and how they are judged.
std::vector<Property> method_answer_properties();

}  // namespace ccdfuzz
