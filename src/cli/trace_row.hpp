#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/table.hpp"
#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// A trace as the row of the JSON output: all that Trace holds, under its own names. loss, margin
/// and slack are null where there is none.
nlohmann::ordered_json trace_row(const std::string& case_id, const std::string& method,
                                 const Trace& trace);

/// A table whose rows are trace_cells.
Table trace_table();
/// One line for people. Level and axis are those of the loss, or of the smallest margin if kept.
std::vector<TableCell> trace_cells(const std::string& case_id, const std::string& method,
                                   const Trace& trace);

}  // namespace ccdfuzz
