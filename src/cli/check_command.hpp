#pragma once

#include <cstdint>
#include <string>

#include "finds/claim_find.hpp"

namespace ccdfuzz {

/// The command that runs a property on what follows: choices, or one draw. method: that of a claim
/// about() one; otherwise empty.
std::string check_command(const std::string& property, const std::string& method,
                          const std::string& on);
/// The options that are these choices, or one draw.
std::string words_of(const ChoiceNumbers& choices);
std::string words_of(std::uint64_t seed, std::uint64_t index);

/// One command that shows what a find was shrunk to, or what failed first.
std::string reproduction(const ClaimFind& find);

}  // namespace ccdfuzz
