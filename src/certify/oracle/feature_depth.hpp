#pragma once

#include "case/case.hpp"

namespace ccdfuzz {

/// How deep a vertex passes through a face, or an edge through an edge, in [0, until]. Whoever
/// moves one of them by less than this, in any direction, leaves a contact in that time. It is a
/// lower bound of the largest such length. It is 0 for a contact at the edge of a face, and for
/// queries of other kinds. With a separation it is that of the touch, where they touch, too. Or it
/// is how much nearer than the separation the points of the witness come, or both at the end, if
/// that is more. A move changes this by no more than its length.
///
/// Proof. The differences of points of the two are a triangle or a parallelogram whose corners move
/// linearly. In a time [t1, t2] it sweeps a solid cell; the cell's surface is the polygon at t1 and
/// at t2 and what its edges sweep. Let D be the volume that three corners span with the origin. If
/// D has one root in the time, a simple one, and the origin is in the polygon then, the surface
/// goes round the origin once. So it does about each point that is nearer to the origin than all
/// of the surface: that is a difference, too. What an edge sweeps lies in the hull of its ends at
/// both times. D has one root if its Bernstein coefficients have one change of sign.
double feature_depth(const Case& known, double until);

}  // namespace ccdfuzz
