#pragma once

#include <string>
#include <vector>

#include "hunt/hunt.hpp"
#include "report/report.hpp"

namespace ccdfuzz {

/// What a hunt leaves beside its page, so that `ccdfuzz report` can make the page again.
struct HuntRecord {
  std::string command;  ///< that hunted
  std::string store;    ///< folder of the counterexamples, as the hunt was told
  double seconds = 0;
  std::vector<HuntCell> cells;
  std::vector<std::string> finds;  ///< paths of the new counterexamples
  HuntCourse course;
  std::vector<MethodInfo> plugins;  ///< among the methods
};

/// FOLDER/hunt.jsonl: one JSON object a line, {"format": "ccdfuzz-hunt", "version": 1, "command",
/// "store", "seconds", "methods"} first, then rows "cell", "store", "plugin", "find" and "sample".
/// Not .json, so that a folder that is a corpus, too, has no entry more.
std::string hunt_record_path(const std::string& folder);

/// Makes the folder if need be. Errors: of the system, naming the path.
Result<void> write_hunt_record(const std::string& folder, const HuntRecord& record);

/// Runs no method, and needs none that it names. A store that has been moved along with the record
/// is found beside it. Errors: naming file, line, field and value.
Result<HuntRecord> read_hunt_record(const std::string& folder);

}  // namespace ccdfuzz
