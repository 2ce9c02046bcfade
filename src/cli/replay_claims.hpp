#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/session.hpp"
#include "finds/failure.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// How many claims of a corpus became what.
struct ReplayedClaims {
  std::uint64_t claims = 0, updated = 0;
  std::array<std::uint64_t, kAllChanges.size()> changes{};
};

/// Runs the property of each file of CORPUS/claims on its choices, in a child. Does nothing where
/// there is no such folder. Throws BadInput for a file that is no claim, or is of a property that
/// is not known.
ReplayedClaims replay_claims(const std::string& corpus, const std::vector<Property>& known,
                             bool update, Session& session);

}  // namespace ccdfuzz
