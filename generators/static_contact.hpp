#pragma once

#include "generators/draw/draw.hpp"
#include "generators/prescribe.hpp"

namespace ccdfuzz {

/// Step II: the control points at t* of two random patches that meet at parameters x. They meet
/// tangentially where the features call for it. For FF, Eq. 19 holds on both. For EF it holds on
/// the face, and its degenerate version on the edge.
///
/// No system is solved. Eq. 19 says that the three points of the last de Casteljau level at x, b_a
/// = Σ_b x_b c_ab, lie in one plane n·p = k. On an edge, it says so of the two of its curve. Each
/// b_a contains one corner control c_aa that no other does. One coordinate of it is free to put b_a
/// into the plane. That is a division by x_a and by a component of n, both powers of two, so every
/// number stays dyadic (Section 5.4). Coincidence is a translation of patch 2.
///
/// Coordinates are drawn from [−2^4, 2^4] in steps of 2^-8. The results are multiples of 2^-15
/// below 2^10, for parameters as prescribe_in_parent gives them.
std::array<Points<Dyadic>, 2> static_contact(const std::array<Barycentric, 2>& x, Draw& draw);

}  // namespace ccdfuzz
