#pragma once

#include <vector>

#include "base/table.hpp"
#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// What each method did in each class.
Table hunt_table(const std::vector<HuntCell>& cells);

}  // namespace ccdfuzz
