#pragma once

#include "case/case.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// draw_contact with a trim for one patch or both (draw_trim), planted about the contact: it is
/// inside, on an edge or a vertex, a float off, in a hole or on an island. is_in_region says which.
Case draw_trimmed(Draw& choices);
/// Those whose contact counts.
Case draw_trimmed_contact(Draw& choices);

/// By a definition of its own, in rationals: the point is on a loop, or the ray from it towards
/// larger v crosses an odd number of edges.
bool is_in_region(const Trim& trim, const Uv<Rational>& at);
bool is_in_regions(const Case& known);

}  // namespace ccdfuzz
