#pragma once

#include "query/answer.hpp"
#include "query/case.hpp"

namespace ccdfuzz {

/// How an answer stands against the truth, every comparison exact:
///   error           the answer is nonsense: a hit without toi, toi NaN or outside [0, t_max]
///   undecided       it says so
///   missed, late    a witness or a contact box proves a contact by some t ≤ t_max; the answer is a
///                   miss, or a hit at a later time
///   false_positive  a hit, and absence of contact on [0, t_max] is proven: collides is false, or
///                   clear_until > t_max
///   unknown         the truth proves neither contact nor absence on [0, t_max]
///   correct         anything else
/// Requires: the truth has been checked (certify/checker), and is relative to this query's t_max;
/// with_t_max gives the case for another one. The contact counts first.
Outcome judge(const Query& query, const Truth& truth, const Answer& answer);

/// The same two patches asked up to another t_max ≥ 0, with what its truth then still says: absence
/// of contact holds for a shorter time but says nothing of a longer one, and a contact is
/// proven only from its time on. Expectations are dropped: they were of another query.
Case with_t_max(const Case& value, double t_max);

}  // namespace ccdfuzz
