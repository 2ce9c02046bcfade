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

/// A patch of another shape of control points of this one: point (i, j) is its point at(i, j).
MovingPatch<double> picked(const MovingPatch<double>& patch, const Shape& to, const auto& at) {
  MovingPatch<double> out{to, {}, {}};
  for_each_control(to, [&](int i, int j) {
    const auto index = static_cast<size_t>(at(i, j));
    out.positions.push_back(patch.positions[index]);
    (patch.has_ends() ? out.ends : out.velocities).push_back(patch.moves()[index]);
    if (!patch.weights.empty()) out.weights.push_back(patch.weights[index]);
  });
  return out;
}

/// Makes the patches of an edited query meet again. Moves a patch, a control point or its velocity,
/// by what is between the two patches at the contact. Returns false if no way is exact.
bool repair(Contact& q, Draw& draw);

}  // namespace ccdfuzz
