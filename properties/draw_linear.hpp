#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A linear query of few bits: point and triangle, two edges, or simpler ones. It is degenerate in
/// one or more of the ways that linear codes fail on:
/// - all in one plane or on one line, at all times;
/// - parallel edges, edges and triangles of no extent, no relative motion;
/// - a contact at a vertex, on an edge or inside, at t = 0, at t_max or in between;
/// - a tangent relative velocity at the contact, so that the coplanarity condition has a double
/// root;
/// - each of these with some numbers moved by one float.
/// All numbers are multiplied by one power of two. Errors: the choices ask for numbers that no
/// double holds.
Result<Query> draw_linear(Draw& choices);

/// The same at a separation: its largest coordinate in [0, t_max], or a part of that. Discarded if
/// one is near the ends of the doubles.
Query draw_linear_apart(Draw& choices);

/// The linear shape of so many corners, 1 to 3.
Shape linear_shape(std::size_t corners);

/// Two edges, or a point and a triangle, of vectors that are drawn so. They touch at t = 1/2, up to
/// the rounding of sums, and often at a corner or on an edge. t_max is 1. is_rigid: all corners of
/// either move alike.
using DrawVector = Vec3<double>(Draw& choices);
Query draw_touching_at_half(Draw& choices, DrawVector* draw_vector, bool is_rigid);

}  // namespace ccdfuzz
