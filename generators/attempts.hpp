#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// A case with its truth and without its origin, or why it was thrown away.
using Attempted = tl::expected<Case, Discard>;
/// One attempt at a case of the options. Requires valid options.
using Attempt = Attempted(const GeneratorOptions& options, Draw& draw);

/// eps_T, as GeneratorOptions say.
Dyadic eps_t(const GeneratorOptions& options);

/// shaped/shaped_case.cpp: two patches of any shapes.
Attempt shaped_case;

/// weighted.cpp: half of the positives and all negatives are regular one-sided cases whose control
/// points are pulled by powers of two. The plane that separates them before t* stays. Control
/// points that have no share in the contact then get a weight of any kind. The other positives are
/// as draw_balanced_contact makes them, and claim the contact alone.
Attempt weighted_case;

/// round.cpp: as draw_round_case makes them, of the families round and apart.
Attempt round_case;

/// trimmed.cpp: a regular one-sided case with loops about the contact, of one surface or both. The
/// contact of a positive is inside of a loop, on an edge, on a vertex or one float inside. Or it is
/// in a sliver, where loops touch, or on an island in a hole. Else the whole patches touch one
/// float outside or in a hole at t*. Those with loops touch at another place later, at t_max, which
/// the witness says. A moving plane proves that nothing touches before t*. A negative ends at t*,
/// when only the whole patches touch. A search in exact arithmetic proves it.
Attempt trimmed_case;

/// ends.cpp: a regular or interior-time case whose patches have ends. Some difference of an end to
/// the start is no double.
Attempt ends_case;

/// separated.cpp: a regular or interior-time contact whose patch 1 is moved along the normal by the
/// separation. The normal's length is a whole number, so that its plane proves all times before.
Attempt separated_case;

/// bodies.cpp: two bodies that touch without depth, by t* at the latest: they move along the plane
/// that is between them. So a vertex passes exactly through another, or along a face. A ball
/// touches an edge or a vertex for one instant, as it passes by. The oracle decides. RP: kept is
/// what is apart at 0 and touches. NMN: they are moved apart by a step (just_missing.hpp).
Attempt grazing_bodies_case;

/// turning.cpp: two bodies of which one turns, or both. They touch as those of framed_bodies do. At
/// t* < 1 a turn is the identity, so that the contact is planted there whatever turns. `from` is
/// −t*·d beside a number that makes its length about 1, and `to` is (1 − t*)·d so. All numbers are
/// floats. With options.plane bodies turn by cosine and sine, else by quaternions. Kept is what the
/// oracle proves to touch at t* first, up to eps_t. RP: t* < t_max ≤ 1. RN: the same bodies with
/// t_max = t* − eps_t.
///
/// Those of turning-grazing and spinning-grazing touch as bodies of grazing_bodies_case do, and
/// turn about the normal of the plane that they move along. So they touch without depth. A spin is
/// about the point that touches. What touches is a vertex and a vertex or an edge, for else the
/// contact would begin before t*, at no rational time. NMN: they are moved apart by a step
/// (just_missing.hpp).
Attempt turning_case;

/// turning.cpp: the same of bodies that spin: as spin_back says, from where those of framed_bodies
/// touch at t*. So they touch near t*, and as the class says but for that rounding. Kept is what
/// the oracle proves to touch within 2^-10 of t* first. RP: t* < t_max ≤ 1. RN: t_max is eps_t or a
/// little more before the contact.
Attempt spinning_case;

/// mesh.cpp: a convex body and a mesh (case/mesh.hpp). They touch as two bodies of framed_bodies
/// do, of which one gave its points to the mesh. What is in contact is inside of a face, on an edge
/// of two faces, or a corner of a fan. More faces are put to edges that there are. Their third
/// corners are those of others, across the edge in the face's plane, far away along the edge, or
/// anywhere. So there are strips, folded sheets and long thin triangles, and some close a
/// tetrahedron. In one mesh of four the body nearly grazes a face before. All numbers are floats.
///
/// The oracle decides. Kept is what touches at t* first, or does not. One-sided, the faces that are
/// touched are fronts. In half of the cases RN, which end after t*, the body comes from behind.
///
/// Those of mesh-grazing touch as bodies of grazing_bodies_case do. A last face is across the way
/// of the body. Kept is what touches another face first, without depth, and then passes well
/// through the last. Whoever stops at the face that is touched first misses that. One-sided, all
/// faces are fronts that can be.
Attempt mesh_case;

}  // namespace ccdfuzz
