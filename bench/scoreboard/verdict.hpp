#pragma once

#include <string>
#include <vector>

#include "records.hpp"

namespace ccdfuzz {

/// What is wrong with a run's record, and the command that repeats the run: a false alarm, or a
/// fault noticed that changes nothing; empty if nothing is.
std::string alarm(const Record& record, const std::vector<PlantedFault>& faults);

/// All alarms, and the faults that neither our properties nor the hunt noticed in any run.
std::vector<std::string> complaints(const std::vector<PlantedFault>& faults,
                                    const Records& records);

}  // namespace ccdfuzz
