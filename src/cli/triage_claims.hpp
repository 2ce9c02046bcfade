#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/triage_files.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {

/// How what a target of claims stopped on is confirmed and stored.
struct ClaimTriageOptions {
  Suite suite;
  std::string folder;          ///< finds of properties, (save_find)
  std::string known;           ///< one more such folder; may be empty, or not there
  std::function<bool()> stop;  ///< true ends shrinking
  bool json = false;
};

/// Confirms the inputs of one target, each in a process apart, shrinks and stores what is new: of
/// each claim one counterexample, and one of each error that putting an input to it ends in. One
/// that could not be shrunk to the end is stored until there is a better. Prints each. Throws
/// BadInput: of the folder or a file.
void triage_claims(const ClaimTriageOptions& options, const std::vector<std::string>& files,
                   TriageWalk& walk);

}  // namespace ccdfuzz
