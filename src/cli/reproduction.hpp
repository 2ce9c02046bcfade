#pragma once

#include <map>
#include <string>

#include "case/case.hpp"

namespace ccdfuzz {

/// The command that puts the case of a file to the methods that are expected to fail on it; to all
/// where none is.
std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect);

}  // namespace ccdfuzz
