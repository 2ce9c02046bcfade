#pragma once

#include "certify/oracle/oracle.hpp"

namespace ccdfuzz {

/// decide for linear queries (linear::is_linear), exactly: without trims it is not undecided,
/// unless a proof takes the checker too long or is too long for a file. A contact at a rational
/// time comes as a witness, or where that is too long as a contact root, with clear_until at that
/// very time. One at an irrational time has an enclosure, whose start gives clear_until. It is at
/// most 2^-64 times as wide as t_max, or as the longest time looked at if it comes later. The
/// contact comes as a witness at its end if the patches are in contact there, too, and else as a
/// contact root. With a trim it is undecided where the whole patches are in contact at a point that
/// is trimmed away: the clearance is up to there. Looks past t_max where options tell of a later
/// time.
Decision decide_linear(const Query& query, const OracleOptions& options);

}  // namespace ccdfuzz
