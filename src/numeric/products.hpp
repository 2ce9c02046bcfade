#pragma once

#include "numeric/ieee_arithmetic.hpp"
#include "numeric/vec3.hpp"

namespace ccdfuzz {

/// a·b as ((x+y)+z): the same sequence of roundings on every compiler, which Eigen's own
/// reduction does not promise.
template <class S>
S dot(const Vec3<S>& a, const Vec3<S>& b) {
  return S(S(S(a[0] * b[0]) + S(a[1] * b[1])) + S(a[2] * b[2]));
}

template <class S>
Vec3<S> cross(const Vec3<S>& a, const Vec3<S>& b) {
  return {S(S(a[1] * b[2]) - S(a[2] * b[1])), S(S(a[2] * b[0]) - S(a[0] * b[2])),
          S(S(a[0] * b[1]) - S(a[1] * b[0]))};
}

}  // namespace ccdfuzz
