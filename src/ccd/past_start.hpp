#pragma once

#include "case/answer.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Moves a hit at t = 0 to a later time, where the query proves one. It does where the hulls of the
/// patches' control points are farther apart at the start than the separation d, exactly. Patches
/// of degree 1 in all are their hulls: their toi is > 0 whenever they start farther apart than d,
/// unless that time is below the least double. Returns other answers as they are, and those of
/// bodies. Where no contact can come by t_max it is a miss.
///
/// Proof. Let D > d be the distance of the hulls, and V the most by which a control point of one
/// moves against one of the other. Points of the patches are means of control points, with the same
/// weights at all times, so they are D − Vt apart at least. That is d at (D − d) / V, which is more
/// than (D² − d²) / (2DV).
Answer past_start(const Query& query, Answer answer);

}  // namespace ccdfuzz
