#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// Two bodies of revolution, or one and a triangle (FF) or a point (VF), that first meet at t*.
/// They are parts of spheres, cylinders, cones and the outsides of tori: rational patches of
/// weights 1 and 2 and their products, which are these surfaces exactly. Where and when they meet
/// is no search's word: one is below a plane and the other above, and each moves with its side of
/// it. Positions and velocities are whole numbers times a power of two, t* is a multiple of 1/8,
/// and t_max is t* to twice as much. The truth is the witness, whose parameters are fractions, and
/// the plane. apart: they meet at a separation > 0, which the query has, and there is no plane.
Case draw_round_case(ContactClass contact, bool apart, Draw& draw);

}  // namespace ccdfuzz
