#pragma once

#include <optional>

#include "case/case.hpp"

namespace ccdfuzz {

/// A moving plane (certificate P) through a contact that separates the patches at all times before
/// it, or nothing. Its normal is one of those that the patches' tangents at the contact offer,
/// their relative velocity there, or the way between its points. What is returned passed
/// check_plane. Requires a witness of the query.
std::optional<MovingPlane> find_plane(const Query& query, const Witness& witness);

/// A moving plane that separates the patches at all times before `until`, or nothing. It is `near`,
/// or has its normal or an axis as normal, and is at a control point of patch 2 at `until`. What is
/// returned passed check_plane, and files may hold its numbers.
std::optional<MovingPlane> find_plane_near(const Query& query, const MovingPlane& near,
                                           const Rational& until);

}  // namespace ccdfuzz
