#pragma once

#include "ccd/certified/normalise.hpp"

namespace ccdfuzz::certified {

/// True only if two linear patches certainly touch at some t in [from, to], by doubles and their
/// error bounds (DERIVATION.md, 7, L9); false says nothing. Nearly all contacts that are not
/// degenerate are certain in a time far shorter than integers take. Times are normalised. Requires
/// can_advance, 0 ≤ from ≤ to ≤ t_max.
bool certainly_touch(const NormalisedQuery& query, double from, double to);

}  // namespace ccdfuzz::certified
