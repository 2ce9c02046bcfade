#pragma once

#include <array>
#include <optional>

#include "certify/linear/real_root.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz::linear {

/// The coordinates of a vector, as polynomials of time.
using MovingVector = std::array<Polynomial, 3>;

/// The first t in the closed [0, until] at which a triangle whose corners a, b, c move linearly
/// contains the origin. Any triangle, also one that is a segment or a point. Requires until ≥ 0. In
/// polynomials of time,
///   D = a·(b×c),  n = (b×c, c×a, a×b),  s_i = n_{i+1}·n_{i+2},  m = Σ|n_i|²,  d_i = the dot
///   products of two corners,
/// the origin is in the triangle at t iff
///   D = 0, all s_i ≥ 0, and (m > 0 or some d_i ≤ 0).
/// Proof. 0 is in the triangle only if a, b, c are linearly dependent, so let D = 0. If m > 0 they
/// span a plane; with ν its normal, n_i = ν·x_i, and x_1·a + x_2·b + x_3·c = 0 is, up to a factor,
/// the only relation between them. So 0 = αa + βb + γc with weights ≥ 0, not all 0, iff no two
/// x_i have opposite signs. If m = 0 all s_i are 0 and a, b, c are on a line through the origin,
/// which is between two of them, or one of them, iff some d_i ≤ 0. The times are closed, so the
/// first is 0 or one at which a polynomial above becomes 0: D, or any of the others where D is 0
/// throughout.
std::optional<RealRoot> first_at_origin(const std::array<MovingVector, 3>& p,
                                        const Rational& until);

/// The first t in the closed [0, until] at which a triangle, as above, is no farther from the
/// origin than a distance > 0. Requires until ≥ 0.
///
/// Proof. It is so wherever a foot of the origin, on a corner, an edge or the plane, is a point of
/// the triangle and as near. Let t > 0 be the first such time. The nearest point is then at the
/// distance exactly. It is the foot on the least feature that holds it, and inside of that. So it
/// was shortly before, and farther away. Hence its squared distance less distance² is 0 at t, and
/// not throughout.
std::optional<RealRoot> first_near(const std::array<MovingVector, 3>& p, const Integer& distance,
                                   const Rational& until);

}  // namespace ccdfuzz::linear
