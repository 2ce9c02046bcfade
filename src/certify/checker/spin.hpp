#pragma once

#include <array>
#include <vector>

#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// What a quaternion of quaternion_of_spin may be off by: the length of the difference.
inline constexpr long kSpinErrorBits = 140;
inline Rational spin_error() {
  return power_of_two(-kSpinErrorBits);
}

/// Within spin_error of the quaternion (cos |u|, sin |u| / |u| · u) of the rotation of a spin w
/// until t, u = w·t/2. Requires a spin without fault (turn.hpp) and 0 ≤ t ≤ 1.
///
/// Proof. All numbers are whole multiples of a unit of 2^-160. Components of u are rounded towards
/// 0, so that |u| ≤ 4 stays. The quaternion changes no more than u: by 1 along it, by sin |u| / |u|
/// across. Both series are of x = |u|² ≤ 16. What 32 terms leave out is below 4^64/64! < 2^-167.
/// A term has x/((2k+1)(2k+2)) times the error of the last, and less than a unit more: so less
/// than 3 units. Then the sums are off by less than 2^7 units, and the second times |u| by less
/// than 2^9. With less than a unit for each component of both vectors that is below 2^10 units.
std::array<Rational, 4> quaternion_of_spin(const std::vector<double>& spin, const Rational& t,
                                           Work& work);

}  // namespace ccdfuzz
