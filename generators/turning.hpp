#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// One attempt at a case of two bodies of which one turns, or both; or why it was thrown away. They
/// touch as those of bodies_case do. At t* < 1 a turn is the identity, so that the contact is
/// planted there whatever turns. `from` is −t*·d beside a number that makes its length about 1, and
/// `to` is (1 − t*)·d so. All numbers are floats. With options.plane bodies turn by cosine and
/// sine, else by quaternions. Kept is what the oracle proves to touch at t* first, up to eps_t.
/// RP: t* < t_max ≤ 1. RN: the same bodies with t_max = t* − eps_t.
///
/// Those of turning-grazing and spinning-grazing touch as bodies of grazing_bodies_case do, and
/// turn about the normal of the plane that they move along. So they touch without depth. A spin is
/// about the point that touches. What touches is a vertex and a vertex or an edge, for else the
/// contact would begin before t*, at no rational time. NMN: they are moved apart by a step
/// (just_missing.hpp).
tl::expected<Case, Discard> turning_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                         Draw& draw);

/// Gives a body a spin of up to 3 radians in [0, 1], about a point in or near it. Its points are
/// turned back from their places, so that they come to them at t, but for a rounding to floats. In
/// a plane, z = 0, it is about the z axis.
void spin_back(MovingPatch<double>& body, double t, bool in_plane, Draw& draw);

/// The same of bodies that spin: as spin_back says, from where those of bodies_case touch at t*. So
/// they touch near t*, and as the class says but for that rounding. Kept is what the oracle proves
/// to touch within 2^-10 of t* first. RP: t* < t_max ≤ 1. RN: t_max is eps_t or a little more
/// before the contact.
tl::expected<Case, Discard> spinning_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                          Draw& draw);

}  // namespace ccdfuzz
