#pragma once

#include <string>
#include <vector>

#include "base/table.hpp"
#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// How a method's tests treated the witness of a case.
struct TraceRow {
  const std::string& id;
  const std::string& method;
  const Trace& trace;
};

/// All that Trace holds, under its own names. loss, margin and slack are null where there is none.
std::string to_json(const TraceRow& row);

std::vector<Table::Column> trace_columns();
/// One line for people. Level and axis are those of the loss, or of the smallest margin if kept.
std::vector<TableCell> trace_cells(const TraceRow& row);

}  // namespace ccdfuzz
