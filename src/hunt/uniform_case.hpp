#pragma once

#include "generators/draw/draw.hpp"
#include "hunt/ground.hpp"

namespace ccdfuzz {

/// A case that anybody would write first, to compare with: all numbers are uniform, and nothing is
/// planted. Bodies are of the ground's kinds. Their points are in a cube of edges 2 whose middle is
/// in one of edges 4, and their speeds are up to 4 along each axis. Linear patches of the class
/// have control points in a cube of edges 2, and speeds of up to 2. t_max is 1. The truth is
/// decided exactly.
Case uniform_case(const HuntGround& ground, ContactClass contact, Draw& draw);

}  // namespace ccdfuzz
