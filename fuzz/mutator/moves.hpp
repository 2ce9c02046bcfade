#pragma once

#include <span>
#include <string_view>

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// One way to mutate.
struct Move {
  std::string_view name;
  bool (*apply)(Contact& q, const Contact& other, Draw& draw);
};

/// All moves.
std::span<const Move> moves();

/// Moves that keep the contact exactly, by construction. Each returns false if a number of the
/// result would not be a double, or if there is nothing to do. The caller must then discard q.

/// Two control points of a patch move against each other, or one without weight alone. Positions,
/// velocities or ends change in the null space of the Bernstein row.
bool shift_in_null_space(Contact& q, Draw& draw);

/// A control point gets another velocity, and is at the same place at t: p + t·v stays.
bool trade_position_for_velocity(Contact& q, Draw& draw);

/// Both patches in other coordinates: moved, with a common velocity, in other units.
bool change_coordinates(Contact& q, Draw& draw);

/// The same patches by other parameters: reversed, rotated, transposed, exchanged.
bool reparametrise(Contact& q, Draw& draw);

/// A patch with one degree more; of a tensor patch in u or v. A control point is divided by that.
bool elevate_degree(Contact& q, Draw& draw);

/// A patch's child cell with the contact in place of it.
bool restrict_to_child(Contact& q, Draw& draw);

/// A patch of `other` in place of one of q, moved to the contact; as it is there at its own t.
bool splice(Contact& q, const Contact& other, Draw& draw);

/// t_max at, just after, or well past the contact.
bool change_horizon(Contact& q, Draw& draw);

/// A separation of a part of the patches' size, or none: a touch is a contact at any.
bool give_separation(Contact& q, Draw& draw);

/// Gives one patch weights of any size, or of powers of two. By those its control points come
/// nearer to the contact or go away from it.
bool give_weights(Contact& q, Draw& draw);

/// Ends in place of the velocities of one patch or both; a t_max beyond 1 is scaled down first.
bool give_ends(Contact& q, Draw& draw);

/// Gives a patch a loop about its contact; or takes or adds a loop or a vertex, or moves a vertex
/// to the next double. False if the loops were none that a patch may have, or the contact left
/// them.
bool change_trim(Contact& q, Draw& draw);

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
