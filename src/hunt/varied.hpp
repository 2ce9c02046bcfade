#pragma once

#include <optional>

#include "case/case.hpp"
#include "generators/draw/draw.hpp"
#include "hunt/ground.hpp"
#include "method/features.hpp"

namespace ccdfuzz {

/// A case of linear patches as a method may be asked it in another way, with its truth decided
/// anew. It may have two positions of each control point, at 0 and at 1, rounded to floats where
/// the ground is of these. It may have a separation. Where a claim keeps patches apart, that is
/// just below the claim. Then most of the queries end before a touch. How often depends on what
/// the method takes, and on the ground: most are of ends where numbers are floats. Other patches
/// may have two positions that are the same motion. nullopt: it is asked as it is.
std::optional<Case> varied(const Case& value, const HuntGround& ground, const Features& features,
                           Draw& draw);

/// A case with a contact after 0, asked up to another time. So its contact is in the last or the
/// first 2^-k of the step, k ≤ 20, or at the end. Where only ordinary cases count, k ≤ 10, and it
/// is not at the end. nullopt if there is none, or the ground has no such case.
std::optional<Case> near_an_end(const Case& value, const HuntGround& ground, Draw& draw);

}  // namespace ccdfuzz
