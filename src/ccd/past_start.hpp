#pragma once

#include "case/answer.hpp"
#include "case/query.hpp"

namespace ccdfuzz {

/// Moves a hit at t = 0 to a later time, where a query with a separation d > 0 proves one. It does
/// where the hulls of the patches' control points are farther apart at the start than d, exactly,
/// or the regions of flat patches (are_flat). Flat patches are their hulls or those regions: their
/// toi is > 0 whenever they start farther apart than d. Exceptions are a time below the least
/// double, and trims of which more than kMostEdgePairs pairs of edges are about as near.
/// Returns other answers as they are, and those of bodies. Where no contact can come by t_max it is
/// a miss.
///
/// Proof. Let D > d be the distance of the hulls or regions. Along each axis let V have the most by
/// which a velocity of one exceeds one of the other. Points of the patches are means of control
/// points, with the same weights at all times. So none moves against another by more than |V|, and
/// they are D − |V|t apart at least. That is d at (D − d) / |V|, which is more than (D² − d²) /
/// (2D|V|).
Answer past_start(const Query& query, Answer answer);

}  // namespace ccdfuzz
