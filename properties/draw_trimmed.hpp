#pragma once

#include "case/case.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// draw_contact with a trim for one patch or both, planted about the contact (draw_trim). The
/// contact may be in the region or not: is_in_region says it.
Case draw_trimmed(Draw& choices);
/// Those whose contact counts.
Case draw_trimmed_contact(Draw& choices);

inline Uv<Rational> exact_place(const Uv<double>& uv) {
  return {exact(uv[0]), exact(uv[1])};
}

/// By a definition of its own, in rationals: the point is on a loop, or the ray from it towards
/// larger v crosses an odd number of edges.
bool is_in_region(const Trim& trim, const Uv<Rational>& at);
bool is_in_regions(const Case& known);

}  // namespace ccdfuzz
