#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fault_list.hpp"
#include "records.hpp"

namespace ccdfuzz {

struct CampaignOptions {
  std::vector<std::string> drivers, faults;  ///< names; empty: all
  std::uint64_t seeds = 5, weak_seeds = 3;
  double seconds = 60, weak_seconds = 10;  ///< CPU time of a run
  bool verbose = false;                    ///< a line a run
};

/// Runs each driver against each fault, what the records have already left out, and adds to these.
/// A driver whose course depends on its seed alone first takes it on the right sources with all
/// faults watched: faults that are never triggered there are decided, and need no run. Equivalent
/// faults get one run, as long as those of weak drivers: a look at their proofs.
/// Returns whether there was no false alarm. Errors: of the file of records.
Result<bool> run_campaign(const CampaignOptions& options, const std::vector<Fault>& faults,
                          Records& records);

}  // namespace ccdfuzz
