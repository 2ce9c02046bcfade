#pragma once

#include <array>
#include <optional>

#include "bezier/patch.hpp"
#include "case/case.hpp"
#include "certify/linear/real_root.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz::linear {

/// True iff first_contact speaks of the patches.
inline bool is_linear(const Query& query) {
  return is_linear_pair(query.patches[0].shape, query.patches[1].shape);
}

/// The time of the first contact of two patches in the closed [0, until], if there is one. They are
/// in contact where they are no farther apart than the separation. Exact for all queries: parallel,
/// coplanar, collinear, static or without extent. Requires is_linear, until ≥ 0, separation ≥ 0.
///
/// The patches are as far apart as the origin is from the set of differences of their points. That
/// is a triangle with corners q_j − p for a point and a triangle, a parallelogram with corners
/// p_i − q_j for two edges. A diagonal splits it into two triangles (origin_in_triangle.hpp).
std::optional<RealRoot> first_contact(const std::array<MovingPatch<Rational>, 2>& patches,
                                      const Rational& until, const Rational& separation = 0);

/// The patches of a valid query.
std::array<MovingPatch<Rational>, 2> exact_patches(const Query& query);

/// The same of a query, in [0, t_max]. Requires a valid query.
std::optional<RealRoot> first_contact(const Query& query);

}  // namespace ccdfuzz::linear
