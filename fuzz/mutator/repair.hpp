#pragma once

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"
#include "generators/weighted.hpp"

namespace ccdfuzz {

/// A patch's positions, or its velocities or ends.
using PatchField = Points<double>& (*)(MovingPatch<double>&);
inline constexpr std::array<PatchField, 2> kPatchFields = {
    [](MovingPatch<double>& patch) -> Points<double>& { return patch.positions; },
    [](MovingPatch<double>& patch) -> Points<double>& { return patch.moves(); }};

/// Makes the patches of an edited query meet again. Moves a patch, a control point or its velocity,
/// by what is between the two patches at the contact. Returns false if no way is exact.
bool repair(Contact& q, Draw& draw);

}  // namespace ccdfuzz
