#pragma once

#include <string>
#include <vector>

#include "fault_list.hpp"

namespace ccdfuzz {

/// Eight hex digits that change with what a fault is: its file, the right text and the wrong one.
std::string definition_hash(const PlantedFault& fault);

/// The same of all faults of a list, in their order.
std::string definition_hash(const std::vector<PlantedFault>& faults);

}  // namespace ccdfuzz
