#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/session.hpp"
#include "finds/replay.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// How many claims of a corpus became what.
struct ReplayedClaims {
  std::uint64_t claims = 0, updated = 0;
  std::array<std::uint64_t, kAllChanges.size()> changes{};
};

/// Puts the choices of each file of CORPUS/claims to its property, in a child, and shows what it
/// does other than expected; with --json every one. update: writes what it does into the file. None
/// where there is no such folder. Errors: throws BadInput for a file that is no claim, or is of a
/// property that is not known.
ReplayedClaims replay_claims(const std::string& corpus, const std::vector<Property>& known,
                             bool update, Session& session);

}  // namespace ccdfuzz
