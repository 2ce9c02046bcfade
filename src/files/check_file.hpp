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

/// The next case; nothing at the end. Errors: as CaseStream, check_case and RunWork::add, naming
/// path and line.
Result<std::optional<NamedCase>> next_checked(CaseStream& cases);

/// Calls visit on every case of the files, one at a time, until it gives an error. Errors: as
/// next_checked.
Result<void> for_each_checked_case(const std::vector<std::string>& paths,
                                   const std::function<Result<void>(const NamedCase&)>& visit);

/// The only case of a file. Errors: as read_case, check_case and RunWork::add.
Result<NamedCase> read_checked_case(const std::string& path);

}  // namespace ccdfuzz
