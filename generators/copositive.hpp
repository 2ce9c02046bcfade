#pragma once

#include "generators/quadratic.hpp"

namespace ccdfuzz {

/// True iff the quadratic polynomial with these six Bernstein coefficients (in Shape's order) is
/// ≥ 0 on the whole triangle; that is, iff the symmetric 3×3 matrix they form is copositive.
/// Exact, complete, and without a square root.
bool nonnegative_on_triangle(const std::array<Dyadic, 6>& heights);

}  // namespace ccdfuzz
