#pragma once

#include "generators/random.hpp"
#include "generators/scene.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

/// The one-sided family: Steps I, II and IV in one go, without solving or discarding anything.
///
/// At t* the control points are c + Σ τ·T + h·m: c is the contact point, T1 and T2 span the contact
/// plane, m points out of it. The tangential coordinates τ are arbitrary but for Σ β τ = 0, β the
/// Bernstein weights at the contact, which puts the contact at c. The heights h are the polar form
/// of a quadratic that is 0 at the contact and positive elsewhere on the patch; patch 1 takes them
/// upwards, patch 2 downwards. So the patches touch at c alone, whatever the rest.
/// All velocities of patch 1 have a smaller normal part than all of patch 2: moving_plane_separates
/// holds by construction.
/// Sizes: patches about 2^2 across, contact point and velocities up to 2^5 and 2^3 a coordinate.
Scene one_sided_scene(ContactClass contact, Random& random);

}  // namespace ccdfuzz
