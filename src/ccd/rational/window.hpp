#pragma once

#include "ccd/rational/gap.hpp"
#include "ccd/time_interval.hpp"

namespace ccdfuzz::exact_ccd {

/// Steps II and III for one axis, both signs, in exact arithmetic. Takes from the ends of `window`
/// the times at which the selected cells are separated on the axis that `gap` is projected on.
/// Times are scaled (Gap), and both ends are window ends (Units). Returns false where all of it is
/// separated.
///
/// Law R1: a time at which the exact gap is ≥ 0 is never taken; so an exact touch (gap = 0) stays,
/// also at the ends.
/// Law R2: false iff the gap is < 0 at both ends, hence between them (the gap is convex).
/// Law R3: an end moves from lo to t only if gap(lo) < 0 and gap(t) ≤ 0, hence gap < 0 on [lo, t);
/// likewise from the right.
/// The new end is the root of the gap rounded outward to the grid, or a little further out. Where
/// doubles hardly tell the gap from 0, an end may stay.
bool cut_window(Gap& gap, Window& window);

}  // namespace ccdfuzz::exact_ccd
