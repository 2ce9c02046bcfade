#pragma once

#include "case/case.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// The exponent e of the size of the patches about their first point, 2^(e-1) to 2^e; 0 if both are
/// one point.
int size_exponent(const Query& query);

/// The case in other coordinates, with the truth that similar() leaves it. At random it is moved
/// and given a common velocity, each of up to 2^40 times the patches' size. Its numbers are
/// multiplied by 2^-1000 to 2^900, and time by 2^-100 to 2^100. All is exact: a change that doubles
/// have no room for is left out. Choices that are 0 change nothing.
Case elsewhere(const Case& base, Draw& draw);

}  // namespace ccdfuzz
