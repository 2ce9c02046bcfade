#pragma once

#include "case/certificate.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Certificate P: true iff a plane proves that the patches do not touch at any t < t*. It is that
/// with this normal through the contact point at t*, moving along with the patches. Exact. false
/// means "not by this plane". Patch 1 is the one that the normal points to.
///
/// Proof. Let the heights n·(S1 − c) ≥ 0 ≥ n·(S2 − c) hold at t* all over both patches, and let
/// n·w1 < n·w2 for all control velocities w1, w2 of the patches. With k between the two,
/// n·(S1(t) − c) ≥ −(t*−t)·max n·w1 and n·(S2(t) − c) ≤ −(t*−t)·min n·w2 for t ≤ t*: the plane
/// n·(p − c) = −(t*−t)k separates the patches strictly while t < t*.
bool moving_plane_separates(const Scene& scene, const Vec3<Dyadic>& normal);

/// That plane, as a case carries it.
MovingPlane moving_plane(const Scene& scene, const Vec3<Dyadic>& normal);

}  // namespace ccdfuzz
