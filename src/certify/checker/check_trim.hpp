#pragma once

#include <span>

#include "bezier/patch.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// True iff the point belongs to the closed even-odd region of the loops; everything does where
/// there are none.
bool is_in_region(const Trim& trim, const Uv<Rational>& at, Work& work);

/// How a closed convex polygon lies, a point and a segment among them. kTouching: an edge of a loop
/// meets it.
enum class Region { kInside, kTouching, kOutside };

/// vertices: in either order around the polygon.
Region region_of(const Trim& trim, std::span<const Uv<Rational>> vertices, Work& work);

/// True iff one edge of a loop holds all points.
bool is_on_one_edge(const Trim& trim, std::span<const Uv<Rational>> points, Work& work);

}  // namespace ccdfuzz
