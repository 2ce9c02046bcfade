#pragma once

#include <string>
#include <vector>

#include "query/case_files.hpp"

namespace ccdfuzz {

/// Checks what a case says of itself against exact arithmetic, as far as that is possible without
/// a CCD method:
///   the query is valid;
///   a witness is a contact (check_contact);
///   collides = true has a witness with t ≤ t_max, collides = false none;
///   clear_until ≥ 0, and no witness lies before it.
/// Not checked here: that absence of contact, by `proof`, really holds; `ccdfuzz verify` repeats
/// that proof. Errors: what is refuted, naming JSON path and value.
Result<void> check_truth(const Case& value);

/// Reads all cases of a file and refuses the first whose truth the checker refutes.
/// Errors: as read_cases and check_truth, naming path and line.
Result<std::vector<NamedCase>> read_checked_cases(const std::string& path);

}  // namespace ccdfuzz
