#pragma once

#include <vector>

#include "generators/shaped/features.hpp"

namespace ccdfuzz {

/// The Bernstein coefficient of u^a·v^b at control point (i, j): C(i,a)/C(n,a)·C(j,b)/C(m,b). On a
/// triangle it is i!/(i−a)!·j!/(j−b)!·(n−a−b)!/n!, by a multiplication with (u + w)^(n−a) and so
/// on. Requires that the shape has the degrees.
Rational coefficient_of(const Shape& shape, int i, int j, int a, int b);

/// A polynomial in u and v of total degree ≤ 2: coefficients of 1, u, v, u², uv and v².
using LowPolynomial = std::array<Dyadic, 6>;

/// c[0] + c[1]·u + c[2]·v
using Linear = std::array<Dyadic, 3>;

LowPolynomial product(const Linear& p, const Linear& q);
LowPolynomial sum(LowPolynomial p, const LowPolynomial& q);

/// Its Bernstein coefficients on the shape, in Shape's order, times odd_denominator(shape), which
/// makes them dyadic. Requires that the shape has the degrees: u² needs degree 2 in u, uv degree 1
/// in both or 2 on a triangle, and so on.
std::vector<Dyadic> coefficients_on(const Shape& shape, const LowPolynomial& p);
Dyadic odd_denominator(const Shape& shape);

/// Bernstein coefficients of heights above a plane: ≥ 0 all over the shape, 0 at the point, and
/// elsewhere:
///   kPoint  positive, but that a degree of 1 leaves them 0 along a line, or everywhere
///   kLine   0 along a line through the point, an edge if the point is on one, else positive
///   kAll    0
/// All are multiples of 2^unit·2^(-2·bits) for parameters of so many bits. certify/checker accepts
/// a moving plane under each of them.
enum class ZeroSet : std::uint8_t { kPoint, kLine, kAll };
std::vector<Dyadic> heights_over(const Shape& shape, const Uv<Dyadic>& at, ZeroSet zeros, long unit,
                                 Draw& draw);

}  // namespace ccdfuzz
