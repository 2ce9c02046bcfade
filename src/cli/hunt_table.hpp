#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "eval/table.hpp"
#include "hunt/hunt.hpp"

namespace ccdfuzz {

/// What each method did in each class.
Table hunt_table(const std::vector<HuntCell>& cells);

/// A cell as one object: {"row": "cell", "class", "method", "n", …}.
nlohmann::ordered_json cell_json(const HuntCell& cell);

}  // namespace ccdfuzz
