#pragma once

#include "case/case.hpp"

namespace ccdfuzz {

/// How deep a vertex passes through a face, or an edge through an edge, in [0, until]: by less than
/// this one of them can be moved, whatever way, and they still touch in that time. A lower bound of
/// the most; 0 where there is none, as of a contact at the edge of a face, and of other queries.
///
/// Proof. The differences of points of the two are a triangle or a parallelogram whose corners move
/// linearly. In a time [t1, t2] it sweeps a solid cell; the cell's surface is the polygon at t1 and
/// at t2 and what its edges sweep. Let D be the volume that three corners span with the origin. If
/// D has one root in the time, a simple one, and the origin is in the polygon then, the surface
/// goes round the origin once. So it does about each point that is nearer to the origin than all
/// of the surface: that is a difference, too. What an edge sweeps is in the hull of its ends at
/// both times, and coefficients of Bernstein of one change of sign tell of one root.
double feature_depth(const Case& known, double until);

}  // namespace ccdfuzz
