#pragma once

#include <string>
#include <vector>

#include "eval/generation_cost.hpp"
#include "eval/rows.hpp"

namespace ccdfuzz {

// An evaluation leaves three files in its folder. answers.jsonl is its run file: what was asked,
// and a line for each case with all answers to it. rows.jsonl has what the cases cost to make, and
// a line for each row of the table of performance. tables.md has the tables as they are printed.
// answers.jsonl appears last: once it is there the others are, too.

/// The run file's --precision where none was given.
inline constexpr std::string_view kOwnPrecision = "the case's own";

std::string answers_path(const std::string& folder);

/// The tables as they are printed: performance, Tables 1 to 3 beside the paper's, Table 4; those of
/// which there is nothing to say are left out.
struct NamedTable {
  std::string title;
  Table table;
};
std::vector<NamedTable> evaluation_tables(const Rows& rows,
                                          const std::vector<GenerationCost>& costs);

/// Writes rows.jsonl and tables.md. Errors: what the system says, naming the path.
Result<void> write_tables(const std::string& folder, const Rows& rows,
                          const std::vector<GenerationCost>& costs);

}  // namespace ccdfuzz
