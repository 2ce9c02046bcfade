#pragma once

#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// A part of a parent patch, and where a point of the parent lies on it.
struct LocalPatch {
  std::array<Barycentric, 3> corners;  ///< the part's, on the parent
  Barycentric x;                       ///< on the part
};

/// Step III, the choice (Appendix E.4): a random sub-triangle around x, with corners on the grid of
/// 2^-kGridBits, 2^-3 to 2^-6 of the parent in size. x must be as prescribe_in_parent gives it. It
/// lies on the part as it does on the parent: inside, on an edge or at a corner. That edge is part
/// of the parent's edge, and that corner is the parent's corner. The corners are chosen so that the
/// coordinates of x on the part are dyadic too: multiples of 1/8 inside, of 2^-10 or coarser on an
/// edge.
LocalPatch choose_local_patch(const Barycentric& x, Draw& draw);
inline constexpr int kGridBits = 13;

/// Step III, the control points of the part: the parent's blossom at pairs of corners, exactly.
Points<Dyadic> extract(const Points<Dyadic>& parent, const LocalPatch& part);

}  // namespace ccdfuzz
