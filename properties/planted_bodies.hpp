#pragma once

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// Claims of a planted case of bodies: its truth holds and is of this kind, its numbers are floats,
/// and it survives a file. Those methods take it that have all features that it needs.
void claim_planted_truth(const Case& known, CaseKind kind, const Features& needs);

}  // namespace ccdfuzz
