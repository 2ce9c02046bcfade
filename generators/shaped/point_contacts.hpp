#pragma once

#include "generators/generate.hpp"
#include "generators/shaped/contact_scene.hpp"

namespace ccdfuzz {

using ShapePair = std::array<Shape, 2>;

/// A scene, and where to put it.
struct PlacedScene {
  ContactScene scene;
  Placement placement;
};

/// A random frame; shift and drift of many bits, as large as the patches.
Placement random_placement(Draw& draw);

/// Patches that touch in one point, each on its own side of the contact plane, and approach each
/// other: one-sided scenes (generators/one_sided.hpp) of any shapes. A degree of 1 can leave a
/// patch flat, and its contact a line or an area. t* = t_max = 1.
ContactScene touching(ContactClass contact, const ShapePair& shapes, Draw& draw);

/// The families that vary such a scene in its motion: kRegular, kInteriorTime, kAtStart, kResting,
/// kSliding, kFlatGrazing, kCommonVelocity.
PlacedScene moving_variant(Family family, ContactClass contact, const ShapePair& shapes,
                           Draw& draw);

/// And in its shape or its numbers: kDegenerate, kSliver, kHighCurvature, kScaled, kMixedScales,
/// kFarAway, kConcurrentLines.
PlacedScene odd_variant(Family family, ContactClass contact, const ShapePair& shapes, Draw& draw);

/// The regular scene with all velocities in the contact plane, for near-hits and near-misses; the
/// latter has patch 2 moved away by 2^-20 to 2^-8.
PlacedScene grazing_variant(bool near_miss, ContactClass contact, const ShapePair& shapes,
                            Draw& draw);

}  // namespace ccdfuzz
