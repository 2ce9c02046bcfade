#pragma once

#include "bezier/patch.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The domain of a triangle or tensor, shrunk by 2^-halvings about a point of it, in doubles that
/// are rounded where they must be.
std::vector<Uv<double>> loop_about(const Shape& shape, const Uv<double>& p, int halvings);

/// A triangle of which p is the first vertex, or is on the side between the first two. The third
/// has few bits.
std::vector<Uv<double>> draw_loop_through(Draw& choices, const Shape& shape, const Uv<double>& p,
                                          bool is_vertex);

/// Reverses each loop or not, as a coin says. Its last vertex stays the last.
void turn_round(Trim& trim, Draw& choices);

/// Loops around, through and beside a point of the domain. Rings about it put it into a hole or on
/// an island. Edges, vertices and slivers pass through it, or one float beside it. The draw is
/// discarded where a patch may not have the loops.
Trim draw_trim(Draw& choices, const Shape& shape, const Uv<double>& p);

}  // namespace ccdfuzz
