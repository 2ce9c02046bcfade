#pragma once

#include "case/query.hpp"

namespace ccdfuzz {

/// The most that a body moves in the step along an axis, or one against the other. It is 0 where
/// one turns from one rotation to another: such bodies move until 1, by their velocities.
double largest_motion(const Query& bodies);

/// Whether engines can be given two bodies of floats in floats, exactly. They are given the motion
/// of each in the step and that of one against the other. They are also given the middle of a
/// capsule, which is two points with a radius, and the way from there to its ends. If bodies turn
/// from one rotation to another, it is only the last two.
bool are_given_as_floats(const Query& bodies);

/// Changes bodies of floats so that they are, in numbers that are floats. Where a motion is none,
/// the step becomes as long as the next power of two. All bodies then move and spin as far in it as
/// before, to 2^-24 of that or the least float. Numbers that are to be subtracted lose their last
/// bits below 2^-22 of the larger of them. The least capsules and largest motions may stay so.
void give_as_floats(Query& bodies);

}  // namespace ccdfuzz
