#pragma once

#include "case/case.hpp"
#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// Two surface patches of few bits that are at one point at t*, a multiple of 1/8, and else
/// anything. They may cross there, and may have touched before. They are triangles of degree 1 to
/// 4, half of them quadratic, and tensor patches of degrees 1 to 3. All numbers are multiples of
/// 2^-16 (of 2^-8 if quadratic) below 2^7, so that they can be moved far away exactly. The truth
/// says when they collide, and nothing of the time before.
Case planted_case(ContactClass contact, Draw& draw);

}  // namespace ccdfuzz
