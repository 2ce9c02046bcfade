#pragma once

#include <string>

#include "fault_list.hpp"

namespace ccdfuzz {

/// Eight hex digits that change with what a fault is: its file, the right text and the wrong one.
std::string definition_hash(const Fault& fault);

}  // namespace ccdfuzz
