#pragma once

#include <optional>

#include "generators/scene.hpp"

namespace ccdfuzz {

/// The quick static penetration check (Appendix D), exactly rather than on sampled directions. Do
/// the patches, given by their control points at t*, lie apart near the contact but for the contact
/// itself? Returns a normal of the contact plane, from patch 2 to patch 1. nullopt if they
/// penetrate, or if the leading terms do not tell.
///   FF         the second fundamental form of one relative to the other is definite
///   EF         the edge curves away from the face, and the patch leaves its edge to that side
///   all others a plane through the contact separates the tangent cones, but for lines in it
/// A filter only: what passes is proven later.
std::optional<Vec3<Dyadic>> static_check(const std::array<Points<Dyadic>, 2>& points,
                                         const std::array<Barycentric, 2>& x);

}  // namespace ccdfuzz
