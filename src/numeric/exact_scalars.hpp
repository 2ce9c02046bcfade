#pragma once

#include "numeric/fraction.hpp"
#include "numeric/rational.hpp"
#include "numeric/vec3.hpp"

namespace Eigen {

/// What Eigen must know of an exact scalar: no rounding, so no epsilon and no precision.
template <class Exact>
struct ExactNumTraits : GenericNumTraits<Exact> {
  using NonInteger = Exact;
  enum { IsInteger = 0, IsSigned = 1, ReadCost = 6, AddCost = 150, MulCost = 100 };
  static constexpr bool kIsExact = true;
  static Exact epsilon() { return Exact(0); }
  static int digits10() { return 0; }
};

template <>
struct NumTraits<ccdfuzz::Integer> : ExactNumTraits<ccdfuzz::Integer> {};
template <>
struct NumTraits<ccdfuzz::Rational> : ExactNumTraits<ccdfuzz::Rational> {};
template <>
struct NumTraits<ccdfuzz::Dyadic> : ExactNumTraits<ccdfuzz::Dyadic> {};
template <>
struct NumTraits<ccdfuzz::Fraction> : ExactNumTraits<ccdfuzz::Fraction> {};

}  // namespace Eigen

namespace ccdfuzz {

inline Vec3<Rational> exact(const Vec3<double>& v) {
  return {exact(v[0]), exact(v[1]), exact(v[2])};
}

inline Vec3<Dyadic> exact_dyadic(const Vec3<double>& v) {
  return {Dyadic::exact(v[0]), Dyadic::exact(v[1]), Dyadic::exact(v[2])};
}

/// S is the number type of an exact or double computation; this is the only way a double enters.
template <class S>
S from_double(double x) {
  if constexpr (std::is_same_v<S, double>) return x;
  if constexpr (std::is_same_v<S, Rational>) return exact(x);
  if constexpr (std::is_same_v<S, Fraction>) return Dyadic::exact(x);
  if constexpr (requires { S::exact(x); }) return S::exact(x);
}

}  // namespace ccdfuzz
