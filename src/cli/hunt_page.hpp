#pragma once

#include "cli/hunt_record.hpp"

namespace ccdfuzz {

/// What a hunt's page shows: its cells, its course, what it found, and what its store held before;
/// if the store is not there, only that, which stderr says, too. Starts no plug-in.
/// Errors: the store cannot be read.
Result<ReportPage> hunt_page(const HuntRecord& record);

}  // namespace ccdfuzz
