#pragma once

#include "properties/draw_lines.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Step III under a policy: where it says that max f + max g < 0, that is so in exact arithmetic.
/// Instantiated for Plain, ErrorBoundIntended and ErrorBoundPrinted.
template <class Policy>
void claim_separation_is_true(const LinePairs& pairs);

}  // namespace ccdfuzz
