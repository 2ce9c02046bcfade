#pragma once

#include <vector>

#include "bezier/shape.hpp"
#include "numeric/rational.hpp"

namespace ccdfuzz {

/// True only if the polynomial with these Bernstein coefficients, in the order of Shape, is ≥ 0 all
/// over the shape's domain. Exact. false means "not seen". It is seen in one of these ways:
/// - All coefficients are ≥ 0.
/// - Its total degree in u and v is at most 2. Then it is seen for certain, by
///   nonnegative_on_triangle on the triangle, or on both halves of the square.
/// - With h = Σ_i B_i(u) r_i(v), on a triangle h = Σ_i B_i(u) r_i(v/(1−u)), every row r_i is ≥ 0 by
///   one of the above.
/// - The same with v, or on a triangle 1−u−v, in the place of u.
bool is_nonnegative(const Shape& shape, const std::vector<Rational>& coefficients);

}  // namespace ccdfuzz
