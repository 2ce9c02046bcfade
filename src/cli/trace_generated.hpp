#pragma once

#include <string>

#include "hunt/trace_campaign.hpp"
#include "numeric/result.hpp"

namespace ccdfuzz {

/// `ccdfuzz trace --generate`: traces generated cases, prints a table of methods and contact
/// classes (or rows of JSON) and each witness that was lost, with the command that shows it again.
/// output: a file for the cases whose witness was lost, or empty. Returns the exit code:
/// kCheckFailed if a method that claims to have no false negative lost one.
Result<int> trace_generated_cases(const TraceCampaignOptions& options, const std::string& output,
                                  bool json);

}  // namespace ccdfuzz
