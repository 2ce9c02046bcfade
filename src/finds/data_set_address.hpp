#pragma once

#include <string>
#include <vector>

#include "case/case_files.hpp"

namespace ccdfuzz {

/// The address of a data set: 32 hex digits, a hash of the content_address of its cases, of whether
/// they collide, and of their order.
std::string data_set_address(const std::vector<NamedCase>& cases);

}  // namespace ccdfuzz
