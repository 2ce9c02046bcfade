#pragma once

#include "case/query.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A linear query (point and triangle, two edges, and what is less) of few bits, degenerate in any
/// of the ways that linear codes fail on, alone or together: everything in one plane or on one
/// line, at all times; parallel edges; edges and triangles of no extent; no relative motion; a
/// contact at a vertex, on an edge or inside, at t = 0, at t_max, in between; one where the
/// relative velocity is tangent, so that the coplanarity condition has a double root; and all that
/// with some numbers moved by one float. All numbers are multiplied by one power of two. Errors:
/// the choices ask for numbers that no double holds.
Result<Query> draw_linear(Draw& choices);

}  // namespace ccdfuzz
