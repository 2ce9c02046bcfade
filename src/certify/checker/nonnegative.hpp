#pragma once

#include <vector>

#include "bezier/shape.hpp"
#include "certify/checker/work.hpp"
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
/// - On a square, of degree 2 in u: h = r_0·(1−u)² + 2r_1·u(1−u) + r_2·u² with r_0 ≥ 0, r_2 ≥ 0 and
///   r_0·r_2 − r_1² ≥ 0 by one of the above, or by being q·g² where q ≥ 0 is seen so. Then h·r_0 is
///   (r_0(1−u) + r_1·u)² + (r_0·r_2 − r_1²)u² ≥ 0, and so is h wherever r_0 > 0. Where it is not,
///   r_1 = 0. Patches of revolution are so above their tangent planes.
/// - The same with v in the place of u.
/// Charges for the divisions that look for g.
bool is_nonnegative(const Shape& shape, const std::vector<Rational>& coefficients,
                    Work* work = nullptr);

}  // namespace ccdfuzz
