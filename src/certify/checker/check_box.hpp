#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// Certificate M: checks in exact arithmetic that the box lies in both domains and in t ≥ 0. Checks
/// also that the patches touch in it, at some t ≤ box.until(), which may lie past t_max.
/// Requires a valid query. Errors: what is wrong, naming the field; more than most_work.
///
/// Proof. Let G = inverse·(S1 − S2) in the offsets δ of the varied unknowns, |δ_i| ≤ radius_i, and
/// G_i = δ_i + r_i(δ). If Σ |coefficients of r_i|·radius^power ≤ radius_i, then G_i ≤ 0 where
/// δ_i = −radius_i and G_i ≥ 0 where δ_i = radius_i. By Poincaré–Miranda G is zero somewhere in the
/// box, and where it is, S1 = S2, as inverse is regular.
Result<void> check_box(const Query& query, const ContactBox& box,
                       std::uint64_t most_work = kMostWork);

}  // namespace ccdfuzz
