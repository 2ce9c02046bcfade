#pragma once

#include <vector>

#include "campaign_options.hpp"
#include "fault_list.hpp"
#include "records.hpp"

namespace ccdfuzz {

/// Runs each driver against each fault, what the records have already left out, and adds to these.
/// A driver whose course depends on its seed alone first takes it on the right sources with all
/// faults watched. Faults that are never triggered there are decided, and need no run. Equivalent
/// faults get one run, as long as those of weak drivers: a look at their proofs.
/// What a driver finds in the right sources ends its course with that seed. Alarms (verdict.hpp) go
/// to stderr at once. Requires check_options. Errors: of the file of records.
Result<void> run_campaign(const CampaignOptions& options, const std::vector<PlantedFault>& faults,
                          Records& records);

}  // namespace ccdfuzz
