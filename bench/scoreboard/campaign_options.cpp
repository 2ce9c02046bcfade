#include "campaign_options.hpp"

#include <algorithm>
#include <iterator>

#include "drivers.hpp"
#include "records.hpp"

namespace ccdfuzz {

bool is_wanted(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

bool is_asked(const CampaignOptions& options, std::string_view fault) {
  return is_wanted(options.faults, fault) || is_wanted(options.faults, kWatchedFaults);
}

std::vector<PlantedFault> asked_faults(const CampaignOptions& options,
                                       const std::vector<PlantedFault>& faults) {
  std::vector<PlantedFault> asked;
  std::ranges::copy_if(faults, std::back_inserter(asked),
                       [&](const PlantedFault& fault) { return is_asked(options, fault.name); });
  return asked;
}

Result<void> check_options(const CampaignOptions& options,
                           const std::vector<PlantedFault>& faults) {
  for (const std::string& name : options.drivers) {
    if (enum_named<Driver>(name)) continue;
    return input_error("--drivers", "no driver \"{}\"; there are: {}", name, enum_names<Driver>());
  }
  for (const std::string& name : options.faults) {
    if (name == kNoFault || name == kWatchedFaults) continue;
    if (std::ranges::find(faults, name, &PlantedFault::name) == faults.end()) {
      return input_error("--faults",
                         "no fault \"{}\"; faults.txt has their names, and "
                         "there are {} and {}",
                         name, kNoFault, kWatchedFaults);
    }
  }
  return {};
}

}  // namespace ccdfuzz
