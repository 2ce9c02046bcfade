#pragma once

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// The sign of (b − a) × (c − a): 1 where a, b, c turn left, −1 right, 0 where they are on a line.
/// Exact for all finite doubles, in any floating-point environment.
int orientation(const Uv<double>& a, const Uv<double>& b, const Uv<double>& c);

/// True iff p lies on the closed segment from a to b.
bool is_on_segment(const Uv<double>& p, const Uv<double>& a, const Uv<double>& b);

/// True iff the ray from p towards larger u crosses the segment. Its lower end belongs to it, its
/// upper end does not; so the rays' parity around a closed polygon says whether p is inside.
/// Requires p not to lie on the segment.
bool crosses_ray(const Uv<double>& p, const Uv<double>& a, const Uv<double>& b);

}  // namespace ccdfuzz
