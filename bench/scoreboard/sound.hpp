#pragma once

#include <array>
#include <string>

#include "case/case.hpp"
#include "method/method_set.hpp"

namespace ccdfuzz {

/// What drivers that know nothing of faults hold the sources against. Each says what is wrong, or
/// nothing.

/// The methods that claim to lose no contact; tdibm-e where nothing under- or overflows.
inline constexpr std::array kSoundMethods = {"tdibm-e", "tdibm-rational", "tdibm-c"};
inline constexpr SearchOptions kDriverSearch = {0x1p-6, 300, 1 << 24};
/// Within this scale (is_within_scale) no product of tdibm-e's does.
inline constexpr int kErrorBoundScale = 60;

/// What the sources without the fault prove of a query, against what those with it say.
std::string contradiction(const Query& query);

/// What is done with a contact.
struct Look {
  bool traces = true;  ///< follow the witness, if there is one, through the methods' tests
  bool asks = true;    ///< ask them about the query
};

/// Checks the truth of a case, and asks the sound methods about it.
std::string lost_contact(const Case& known, Look look, MethodSet& methods);

}  // namespace ccdfuzz
