#pragma once

#include <optional>

#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// The plane in which patches slide along each other.
struct GrazingPlane {
  std::array<Vec3<Dyadic>, 2> tangent;  ///< largest component in [1/2, 1), multiples of 2^-18
  Vec3<Dyadic> normal;                  ///< ±tangent[0] × tangent[1], from patch 2 to patch 1
};

/// A plane through the contact that separates the patches there, given by vectors of few bits.
/// Where the contact has directions that both patches have in common with the plane (FF EF EE VF),
/// they are these. The rest are random. points: control points at t*, for which static_check has
/// found `normal`. nullopt if none was found in a few tries, or only one of many bits.
std::optional<GrazingPlane> grazing_plane(const std::array<Points<Dyadic>, 2>& points,
                                          const std::array<Barycentric, 2>& x,
                                          const Vec3<Dyadic>& normal, Draw& draw);

/// Step IV of a near-hit (Section 5.2, kinematic degeneracies): velocities under which the patches
/// are at `points` at t*. By them the contact points move relative to each other within the contact
/// plane, and do move. Control points that bear on the contact are deformed within the plane, the
/// others also towards the other patch.
std::array<MovingPatch<Dyadic>, 2> set_grazing(const std::array<Points<Dyadic>, 2>& points,
                                               const PrescribedContact& contact,
                                               const GrazingPlane& plane, Draw& draw);

/// Near-misses stay 2^-20 to 2^-8 apart.
inline constexpr int kLeastGap = -20, kLargestGap = -8;

/// The near-miss of a near-hit: patch 2 moved away from patch 1 by 2^exponent along one coordinate.
void part(Scene& scene, int exponent);

}  // namespace ccdfuzz
