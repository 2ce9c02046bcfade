#pragma once

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// Claims of a planted case of bodies: its truth holds and is of this kind, its numbers are floats,
/// and it survives a file. Those methods take it that have all features that it needs.
void claim_planted_truth(const Case& known, CaseKind kind, const Features& needs);

/// Claims of two decisions of the same bodies, the first of which is decided. Both say the same,
/// and neither has its witness at a time at which the other is clear.
void claim_same_time(const Truth& one, const Truth& other);

}  // namespace ccdfuzz
