#pragma once

#include <functional>
#include <string>
#include <vector>

#include "case/checked_case.hpp"
#include "files/case_files.hpp"

namespace ccdfuzz {

/// As check_case, with the tree of the case, if it has one, from the file `trees`. Errors also:
/// those of tree_of.
Result<CheckedCase> check_with_trees(Case value, const std::string& trees);

/// The same of a case from a file, and the trees beside it. Errors: naming its id, too.
Result<CheckedCase> check_case(const NamedCase& named);

/// Calls visit on every case of the files, one at a time, until it gives an error. Errors: as
/// CaseStream, check_case and RunWork::add.
Result<void> for_each_checked_case(const std::vector<std::string>& paths,
                                   const std::function<Result<void>(const NamedCase&)>& visit);

/// Reads all cases of a file and checks them. Errors: as read_cases, check_case and RunWork::add,
/// naming path and line.
Result<std::vector<NamedCase>> read_checked_cases(const std::string& path);

}  // namespace ccdfuzz
