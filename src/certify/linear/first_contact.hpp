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

/// The exact first contact of a linear query.
struct FirstContact {
  RealRoot time;
  /// Three pairs of control points, one of each patch; at that time the origin is in the triangle
  /// of their differences.
  std::array<std::array<int, 2>, 3> corners;
};

/// The first contact of two patches at a time in the closed [0, until], if there is one. Exact for
/// all queries: parallel, coplanar, collinear, static or without extent. Requires is_linear, until
/// ≥ 0.
///
/// The patches touch iff the origin is in the set of differences of their points. That is a
/// triangle with corners q_j − p for a point and a triangle, a parallelogram with corners
/// p_i − q_j for two edges, which a diagonal splits into two triangles (OriginInTriangle).
std::optional<FirstContact> first_contact(const std::array<MovingPatch<Rational>, 2>& patches,
                                          const Rational& until);

/// The patches of a valid query.
std::array<MovingPatch<Rational>, 2> exact_patches(const Query& query);

/// The same in [0, t_max]. Requires a valid query.
std::optional<FirstContact> first_contact(const Query& query);

/// Parameters of both patches at which the origin of the triangle lies: exact at the time of a
/// contact, near them at a time near it.
std::array<Uv<Rational>, 2> parameters_at(const std::array<MovingPatch<Rational>, 2>& patches,
                                          const std::array<std::array<int, 2>, 3>& corners,
                                          const Rational& t);

}  // namespace ccdfuzz::linear
