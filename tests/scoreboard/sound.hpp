#pragma once

#include <array>
#include <string>

#include "eval/by_spec.hpp"
#include "query/case.hpp"

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

/// The witness of a case, which is checked, followed through the tests of the sound methods.
/// ask: put the query to them too.
std::string lost_contact(const Case& known, bool ask, TracerSet& tracers);

}  // namespace ccdfuzz
