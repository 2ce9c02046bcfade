#pragma once

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

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

}  // namespace ccdfuzz
