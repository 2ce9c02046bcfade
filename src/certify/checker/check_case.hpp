#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/case_files.hpp"
#include "case/checked_case.hpp"

namespace ccdfuzz {

/// Checks that the case's clearance holds and proves all that the case says of absence. That is no
/// contact in the closed [0, t_max] if collides is false, and none in the half-open [0,
/// clear_until). trees: the file of trees beside the case, read if the clearance is a tree. Errors:
/// what is missing or refuted, naming JSON path, or the file.
Result<void> check_absence(const Case& value, const std::string& trees);

/// Checks all that a case proves: check_truth and, if it has a certificate of absence,
/// check_absence. What it says of absence without a certificate stays unproven: it is no error, and
/// no answer is judged by it. trees: the file of trees beside the case.
/// Errors: what is refuted, naming JSON path and value; a tree that is not there.
Result<CheckedCase> check_case(Case value, const std::string& trees);

/// The same of a case from a file. Errors: naming its id, too.
Result<CheckedCase> check_case(const NamedCase& named);

/// The same; where it is refused, nothing is known of it.
CheckedCase checked_or_unknown(const Case& value, const std::string& trees = "");

/// The same of what proves a contact alone; nothing is known of absence.
CheckedCase checked_contact(Case value);

/// The same of the next case of a run, one at a time. Errors: those, and of RunWork::add.
Result<void> check_in_run(const NamedCase& named);

/// Calls visit on every case of the files, one at a time, until it gives an error. Errors: as
/// CaseStream and check_in_run.
Result<void> for_each_checked_case(const std::vector<std::string>& paths,
                                   const std::function<Result<void>(const NamedCase&)>& visit);

/// Reads all cases of a file and refuses the first that check_in_run refuses. Errors: as
/// read_cases and check_in_run, naming path and line.
Result<std::vector<NamedCase>> read_checked_cases(const std::string& path);

}  // namespace ccdfuzz
