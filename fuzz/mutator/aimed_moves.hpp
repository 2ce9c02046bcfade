#pragma once

#include "fuzz/mutator/witnessed_query.hpp"

namespace ccdfuzz {

/// Moves towards what breaks geometry: coincidences and near-coincidences. Each edits control
/// points as it likes and then makes the query whole again (repair). Returns false where that is
/// not exact, or there is nothing to do; the query is then to be thrown away.

/// A few coordinates or velocities by a few floats.
bool nudge(WitnessedQuery& q, Random& random);

/// A control point's velocity, or position, that of another one but for a few floats: nearly equal
/// slopes or intercepts, nearly parallel lines.
bool make_twins(WitnessedQuery& q, Random& random);

/// Two control points of a patch with two coordinates in common: an edge along an axis.
bool align_edge(WitnessedQuery& q, Random& random);

/// All of a patch in one coordinate plane, or all of its velocities.
bool flatten(WitnessedQuery& q, Random& random);

/// One to three control points that follow each other, onto another one, and moving with it.
bool collapse(WitnessedQuery& q, Random& random);

/// Coordinates rounded to few bits.
bool snap_to_lattice(WitnessedQuery& q, Random& random);

/// Velocities to zero, or both patches' velocities to one.
bool stop_motion(WitnessedQuery& q, Random& random);

/// A control point's coordinates or velocity far larger or smaller than the others'.
bool stretch(WitnessedQuery& q, Random& random);

}  // namespace ccdfuzz
