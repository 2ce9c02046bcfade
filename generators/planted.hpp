#pragma once

#include "generators/random.hpp"
#include "generators/scene.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

/// Two patches of few bits that are at one point at t*, a multiple of 1/8, and else anything: they
/// may cross there, and may have touched before. All numbers are multiples of 2^-8 below 2^7, so
/// that they can be moved far away exactly. The scene has no normal.
Scene planted_scene(ContactClass contact, Random& random);

}  // namespace ccdfuzz
