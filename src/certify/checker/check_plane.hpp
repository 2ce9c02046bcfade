#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Certificate P: checks in exact arithmetic that the plane separates the patches at every t in
/// [0, until). Requires a valid query. Errors: what is wrong, naming the field; more than
/// most_work.
///
/// Proof. At t* = until let n·S1 − offset ≥ 0 ≥ n·S2 − offset all over both patches, and let
/// n·w1 < n·w2 for all control velocities w1, w2 of the patches. Then with k = max n·w1 and t < t*,
/// n·S1(t) − offset ≥ −(t*−t)·k and n·S2(t) − offset ≤ −(t*−t)·min n·w2 < −(t*−t)·k.
Result<void> check_plane(const Query& query, const MovingPlane& plane,
                         std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
