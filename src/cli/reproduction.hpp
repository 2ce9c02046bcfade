#pragma once

#include <map>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace ccdfuzz {

/// The command that asks the methods that are expected to fail on the case of a file; or all,
/// if none is.
std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect);

/// The command that replays a folder of finds of these methods, their plug-ins allowed.
std::string replay_command(const std::string& folder, std::vector<std::string> methods);

}  // namespace ccdfuzz
