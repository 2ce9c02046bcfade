#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Certificate W: checks in exact arithmetic that the witness lies in both domains and at a time t
/// ≥ 0, and that both patches are at the same point there. With a separation: no farther apart than
/// that. t may be past t_max. Shares no code with src/ccd. Requires a valid query. Errors: what is
/// wrong, naming the field; more than most_work.
Result<void> check_contact(const Query& query, const Witness& witness,
                           std::uint64_t most_work = kMostWork);

/// check_contact, and t ≤ t_max: the query's answer is "hit", no later than t.
Result<void> check_witness(const Query& query, const Witness& witness,
                           std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
