#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// Moves patch 1 by way, and gives the query the length of way, rounded up, as its separation. If
/// they touched at a plane to which way is normal, and way is towards patch 1, they come as near as
/// that there and no nearer. Requires velocities. False, with a spoilt query, if a number would be
/// rounded.
bool move_apart(Query& query, const Vec3<Dyadic>& way);

}  // namespace ccdfuzz
