#pragma once

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Moves towards what breaks geometry: coincidences and near-coincidences. Each edits control
/// points as it likes and then repairs the query (repair). Returns false where that is
/// not exact, or there is nothing to do; the query is then to be thrown away.

/// A few coordinates or velocities by a few floats.
bool nudge(Contact& q, Draw& draw);

/// A control point's velocity, or position, that of another one up to a few floats: nearly equal
/// slopes or intercepts, nearly parallel lines.
bool make_twins(Contact& q, Draw& draw);

/// Two control points of a patch with two coordinates in common: an edge along an axis.
bool align_edge(Contact& q, Draw& draw);

/// All of a patch in one coordinate plane, or all of its velocities.
bool flatten(Contact& q, Draw& draw);

/// One to three control points that follow each other, onto another one, and moving with it.
bool collapse(Contact& q, Draw& draw);

/// Coordinates rounded to few bits.
bool snap_to_lattice(Contact& q, Draw& draw);

/// Velocities to zero, or both patches' velocities to one.
bool stop_motion(Contact& q, Draw& draw);

/// A control point's coordinates or velocity far larger or smaller than the others'.
bool stretch(Contact& q, Draw& draw);

}  // namespace ccdfuzz
