#pragma once

#include <optional>
#include <vector>

#include "generators/scene.hpp"

namespace ccdfuzz {

/// The first-order shape of a patch at a point of it: S goes from there into every nonnegative
/// combination of `sides`, and along every combination of `lines`.
///   face    2 lines, no side
///   edge    1 line along the edge, 1 side into the patch
///   corner  2 sides along its edges
struct TangentCone {
  std::vector<Vec3<Dyadic>> lines;
  std::vector<Vec3<Dyadic>> sides;
};

TangentCone tangent_cone(const Points<Dyadic>& points, const Barycentric& x);

/// A vector N with N·a > 0 for every a in `above` and N·t = 0 for every t in `level`, if there is
/// one; exact. May fail to find one where the vectors do not span space.
std::optional<Vec3<Dyadic>> common_normal(const std::vector<Vec3<Dyadic>>& above,
                                          const std::vector<Vec3<Dyadic>>& level);

/// The normal of a plane through the contact that has cone_1 above it, cone_2 below it, with both
/// cones' lines in it; and `above` above it.
std::optional<Vec3<Dyadic>> separating_normal(const TangentCone& cone_1, const TangentCone& cone_2,
                                              std::vector<Vec3<Dyadic>> above = {});

}  // namespace ccdfuzz
