#pragma once

#include <string>
#include <string_view>

#include "base/result.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Reads the query of a JSON text that has patches and t_max as a case does, whatever else it has.
/// Errors: as parse_case.
Result<Query> parse_query(std::string_view json, const std::string& file);

}  // namespace ccdfuzz
