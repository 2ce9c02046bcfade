#pragma once

#include <map>
#include <string>

#include "case/case.hpp"

namespace ccdfuzz {

/// The command that asks the methods that are expected to fail on the case of a file; or all,
/// if none is.
std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect);

}  // namespace ccdfuzz
