#pragma once

#include <type_traits>
#include <utility>

#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz {

/// A coordinate of a Vec3, or of an array of three.
template <class Vector>
using Coordinate = std::remove_cvref_t<decltype(std::declval<const Vector&>()[0])>;

/// a·b as ((x+y)+z): the same sequence of roundings on every compiler, which Eigen's own
/// reduction does not promise.
template <class Vector>
Coordinate<Vector> dot(const Vector& a, const Vector& b) {
  using S = Coordinate<Vector>;
  return S(S(S(a[0] * b[0]) + S(a[1] * b[1])) + S(a[2] * b[2]));
}

template <class Vector>
Vector cross(const Vector& a, const Vector& b) {
  using S = Coordinate<Vector>;
  return {S(S(a[1] * b[2]) - S(a[2] * b[1])), S(S(a[2] * b[0]) - S(a[0] * b[2])),
          S(S(a[0] * b[1]) - S(a[1] * b[0]))};
}

}  // namespace ccdfuzz
