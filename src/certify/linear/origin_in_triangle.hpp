#pragma once

#include <array>
#include <optional>

#include "certify/linear/real_root.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz::linear {

/// The coordinates of a vector, as polynomials of time.
using MovingVector = std::array<Polynomial, 3>;

/// When does a triangle whose corners a, b, c move linearly contain the origin? Any triangle, also
/// one that is a segment or a point. In polynomials of time,
///   D = a·(b×c),  n = (b×c, c×a, a×b),  s_i = n_{i+1}·n_{i+2},  m = Σ|n_i|²,  d_i = the dot
///   products of two corners,
/// the origin is in the triangle at t iff
///   D = 0, all s_i ≥ 0, and (m > 0 or some d_i ≤ 0).
/// Proof. 0 is in the triangle only if a, b, c are linearly dependent, so let D = 0. If m > 0 they
/// span a plane; with ν its normal, n_i = ν·x_i, and x_1·a + x_2·b + x_3·c = 0 is, up to a factor,
/// the only relation between them. So 0 = αa + βb + γc with weights ≥ 0, not all 0, iff no two
/// x_i have opposite signs. If m = 0 all s_i are 0 and a, b, c are on a line through the origin,
/// which is between two of them, or one of them, iff some d_i ≤ 0.
class OriginInTriangle {
 public:
  explicit OriginInTriangle(const std::array<MovingVector, 3>& p);

  /// The first t in the closed [0, until] at which the origin is in the triangle. Requires
  /// until ≥ 0. The times are closed, so the first is 0 or one at which a polynomial above
  /// becomes 0: D, or any of the others where D is 0 throughout.
  std::optional<RealRoot> first(const Rational& until) const;

 private:
  bool contains(RealRoot& t) const;

  Polynomial det_;
  std::array<Polynomial, 3> same_side_;
  Polynomial spread_;
  std::array<Polynomial, 3> dots_;
};

/// Weights ≥ 0 with sum 1 that give the origin as a mean of three points, if it is in their
/// triangle. Else any weights, near those if it is near it.
std::array<Rational, 3> weights_of_origin(const std::array<Vec3<Rational>, 3>& corners);

}  // namespace ccdfuzz::linear
