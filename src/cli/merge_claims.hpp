#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// The counts of a merge of inputs of claims.
struct MergedClaims {
  std::uint64_t entries = 0, taken = 0, now = 0;
  std::uint64_t without_input = 0;  ///< finds that did not fail again, which have no choices
};

/// Whether a path is of a folder of inputs of claims itself, by its name (kClaims).
bool is_claims_folder(const std::string& path);

/// Copies the inputs of claims of corpora into another corpus. They are in folders called kClaims,
/// any of which may also be named itself; the new one is made if there are any. An entry whose name
/// is its claim and error (ClaimFind::stem) replaces one that is shrunk less. Its name is its hash
/// if another entry has the name or expects something else. An input that is there already stays as
/// it is. known: all the properties that there are. Throws BadInput: of a folder or file; an entry
/// of an unknown property, naming it.
MergedClaims merge_claims(const std::vector<std::string>& corpora, const std::string& into,
                          const std::vector<Property>& known);

}  // namespace ccdfuzz
