#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "eval/answer_record.hpp"
#include "eval/ask.hpp"

namespace ccdfuzz {

/// An answer as the row of the JSON output. toi is null after a miss, uv unless it is a hit; note
/// is there if there is something to say, and error, the name of one.
nlohmann::ordered_json answer_row(const std::string& case_id, const std::string& method,
                                  const Judged& judged);

}  // namespace ccdfuzz
