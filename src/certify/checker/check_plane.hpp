#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Certificate P: checks in exact arithmetic that the plane keeps the patches farther apart than
/// the separation d ≥ 0 at every t in [0, until). Requires a valid query. Errors: what is wrong,
/// naming the field; more than most_work.
///
/// Proof. At t* = until let n·S1 − offset ≥ g and n·S2 − offset ≤ 0 all over both patches, where
/// g ≥ d·|n|. Let n·w1 < n·w2 for all control velocities w1, w2 of the patches, so that n ≠ 0. With
/// ends, these are the ways from the start. A point of a patch moves by a weighted mean of them,
/// whatever its weights are. So at t < t*
/// n·(S1(t) − S2(t)) ≥ g + (t* − t)·(min n·w2 − max n·w1) > g ≥ d·|n|,
/// and |S1(t) − S2(t)| > d. Trims only leave points out. g is d·|n| where that is rational, and
/// else a little more: a plane that is as near as d at t* is accepted in the former case alone.
Result<void> check_plane(const Query& query, const MovingPlane& plane,
                         std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
