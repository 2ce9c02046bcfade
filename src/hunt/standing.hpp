#pragma once

#include "ccd/witness_trace/trace.hpp"
#include "hunt/population.hpp"

namespace ccdfuzz {

/// How nearly the contact of q was lost in its trace, and what decided that. Of methods that
/// compare at the ends of windows: the slack. Of the others: how far apart the patches still are
/// where the nearest exclusion ends, by the speed at which they close in the contact, in units of
/// what rounding may do to a height (2^-53 of the largest on the way). Time alone would favour
/// patches that are fast, not those whose heights are rounded most. Computed in double precision: a
/// guide, no proof.
Standing standing_of(const Contact& q, const Trace& trace);

}  // namespace ccdfuzz
