#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A point and a triangle, or two edges, with numbers of full doubles, that graze each other: a
/// corner of the one crosses the plane of the other on an edge, but for rounding, with a motion
/// across that edge that is 0 there. So whether they touch is up to the last bits, about that time
/// the corner is on one side of the edge for long, and where edges turn it may be on the other for
/// a moment. The crossing is in the time step, near its end or at it.
Query draw_grazing(Draw& choices);

}  // namespace ccdfuzz
