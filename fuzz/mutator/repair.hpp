#pragma once

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// A patch's positions, or its velocities or ends.
using PatchField = Points<double>& (*)(MovingPatch<double>&);
inline constexpr std::array<PatchField, 2> kPatchFields = {
    [](MovingPatch<double>& patch) -> Points<double>& { return patch.positions; },
    [](MovingPatch<double>& patch) -> Points<double>& { return patch.moves(); }};

/// x += by. Returns false, and leaves x, if the sum is not a double.
bool add_exactly(double& x, const Dyadic& by);
bool add_exactly(Vec3<double>& x, const Vec3<Dyadic>& by);

/// v / by, if that is dyadic.
std::optional<Vec3<Dyadic>> divided(const Vec3<Dyadic>& v, const Dyadic& by);

/// Makes the patches of an edited query meet again: moves a patch, a control point or its velocity,
/// by what is between the two patches at the contact. Returns false if no way is exact.
bool repair(Contact& q, Draw& draw);

}  // namespace ccdfuzz
