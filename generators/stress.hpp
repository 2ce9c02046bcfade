#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// The stress families that are made of quadratic triangles, unless other shapes are asked for.
inline constexpr std::array kQuadraticFamilies = {Family::kFlatGrazing, Family::kCommonVelocity,
                                                  Family::kScaled, Family::kTwins,
                                                  Family::kInteriorTime};

/// A scene of one of them.
Scene stress_scene(Family family, ContactClass contact, Draw& draw);

}  // namespace ccdfuzz
