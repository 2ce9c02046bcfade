#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/case_files.hpp"
#include "io/table.hpp"
#include "method/method_set.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// The command that asks the methods that are expected to fail on the case of a file; or all,
/// if none is.
std::string reproduction(const std::string& path, const std::map<std::string, Expected>& expect);

/// The command that writes a find of a plug-in as a test of the engine whose name it has. Nothing
/// where there is none of this name, or it has no test of the case.
std::optional<std::string> export_command(const Find& find);

/// The command that replays a folder of finds of these methods, their plug-ins allowed.
std::string replay_command(const std::string& folder, std::vector<std::string> methods);

/// False for plug-ins and bodies, which are not traced: none of their mutants is known to be lost.
bool any_is_traced(const std::vector<HuntCell>& cells);

/// The results of each method, or of each in each class.
Table hunt_table(const std::vector<HuntCell>& cells, bool by_class);

/// An entry as its expectations say. Where those are of a time that a method reported, a method
/// that may be started (is_admitted) is asked for it again. Errors: its truth is refuted; a method
/// that there is not.
Result<ReportedCase> reported_entry(const NamedCase& entry, MethodSet& methods);

/// The data of a page of a hunt of these methods: its cells, its course, its finds, and the earlier
/// ones of its store. Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntReport& hunted, const std::vector<std::string>& methods,
                             Store& store);

}  // namespace ccdfuzz
