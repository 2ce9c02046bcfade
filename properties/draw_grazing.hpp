#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A point and a triangle, or two edges, with numbers of full doubles, that graze each other. A
/// corner of one crosses the plane of the other on an edge, except for rounding, and its motion
/// across that edge is 0 there. So the last bits decide whether they touch. The corner stays on one
/// side of the edge for long, and where edges turn it may be on the other for a moment. The
/// crossing is in the time step, near its end or at it.
Query draw_grazing(Draw& choices);

}  // namespace ccdfuzz
