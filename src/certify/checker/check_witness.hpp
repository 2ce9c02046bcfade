#pragma once

#include "query/case.hpp"

namespace ccdfuzz {

/// Certificate W: checks in exact arithmetic that the witness lies in both domains and in
/// [0, t_max], and that both patches are at the same point there. Shares no code with src/ccd.
/// Errors: what is wrong, naming the field.
Result<void> check_witness(const Query& query, const Witness& witness);

}  // namespace ccdfuzz
