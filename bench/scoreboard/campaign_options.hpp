#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fault_list.hpp"

namespace ccdfuzz {

struct CampaignOptions {
  std::vector<std::string> drivers;  ///< names; empty: all
  std::vector<std::string> faults;   ///< names, also kNoFault and kWatchedFaults; empty: all
  std::uint64_t seeds = 5, weak_seeds = 3;
  std::optional<std::uint64_t> only_seed;  ///< this one in place of 1 to seeds
  double seconds = 60, weak_seconds = 10;  ///< CPU time of a run
  bool verbose = false;                    ///< a line a run
};

/// Whether a list of names, all if it is empty, has this one.
bool is_wanted(const std::vector<std::string>& names, std::string_view name);

/// Whether results about this fault are wanted: a run with all faults watched is about all of them.
bool is_asked(const CampaignOptions& options, std::string_view fault);
std::vector<PlantedFault> asked_faults(const CampaignOptions& options,
                                       const std::vector<PlantedFault>& faults);

/// Errors: a driver or a fault that is none, naming the option.
Result<void> check_options(const CampaignOptions& options, const std::vector<PlantedFault>& faults);

}  // namespace ccdfuzz
