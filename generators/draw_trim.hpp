#pragma once

#include "bezier/patch.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The domain of a triangle or tensor, shrunk by 2^-halvings about a point of it, in doubles that
/// are rounded where they must be.
std::vector<Uv<double>> loop_about(const Shape& shape, const Uv<double>& p, int halvings);

/// Loops around, through and beside a point of the domain: rings about it, so that it is in a hole
/// or on an island; edges and vertices through it, and one float off; slivers. Discarded where they
/// are none that a patch may have.
Trim draw_trim(Draw& choices, const Shape& shape, const Uv<double>& p);

}  // namespace ccdfuzz
