#pragma once

#include <optional>

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/prescribe.hpp"
#include "generators/scene.hpp"

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

/// Velocities are as large as a local patch: up to 2^2, in steps of 2^-15.
inline constexpr int kSpeedBits = 17;
inline constexpr long kSpeedUnit = -15;

/// Step IV: gives the patches velocities under which they are at `points` at t*, and traces their
/// control points back to t = 0.
///
/// The velocity of each contact point is drawn first, on its side of the contact plane: patch 1
/// moves against the normal and patch 2 along it. That is for FF, EF, EE and VF; VE and VV have no
/// restriction, as in Section 5.3. Control velocities are that plus a deformation of random
/// strength whose weighted mean at the contact is zero. So Σ β v is the velocity drawn.
std::array<MovingPatch<Dyadic>, 2> set_in_motion(const std::array<Points<Dyadic>, 2>& points,
                                                 const PrescribedContact& contact,
                                                 const Vec3<Dyadic>& normal, ContactClass kind,
                                                 Draw& draw);

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

/// Steps I to IV as the paper has them: parameters, two random patches in (tangential) contact, the
/// static check, local parts of them, velocities. nullopt if the static check discards it. Nothing
/// is known yet of the time before t*.
/// Every number is a multiple of 2^-41 below 2^11, which a double holds.
/// grazing: the contact points' relative velocity lies in the contact plane.
std::optional<Scene> paper_scene(ContactClass contact, bool grazing, Draw& draw);

}  // namespace ccdfuzz
