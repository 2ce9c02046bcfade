#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "ccd/certified/signs_on_part.hpp"
#include "numeric/ieee_arithmetic.hpp"
#include "numeric/wide_int.hpp"

namespace ccdfuzz::certified {

/// A polynomial of time with integer coefficients of at most Bits − 1 bits.
template <int Degree, int Bits>
struct ShortPolynomial {
  using Int = WideInt<Bits>;

  std::array<Int, Degree + 1> c;  ///< by powers, from 0 up

  ShortPolynomial() { c.fill(Int(0)); }
  ShortPolynomial(const Int& c0, const Int& c1) requires(Degree == 1) : c{c0, c1} {}

  friend ShortPolynomial operator+(ShortPolynomial a, const ShortPolynomial& b) {
    for (std::size_t i = 0; i <= Degree; ++i) a.c[i] += b.c[i];
    return a;
  }
  friend ShortPolynomial operator-(ShortPolynomial a, const ShortPolynomial& b) {
    for (std::size_t i = 0; i <= Degree; ++i) a.c[i] -= b.c[i];
    return a;
  }
  template <int Others, int OtherBits>
  ShortPolynomial<Degree + Others, Bits + OtherBits> operator*(
      const ShortPolynomial<Others, OtherBits>& b) const {
    ShortPolynomial<Degree + Others, Bits + OtherBits> r;
    for (std::size_t i = 0; i <= Degree; ++i) {
      for (std::size_t j = 0; j <= Others; ++j) r.c[i + j] += c[i] * b.c[j];
    }
    return r;
  }

  /// What on_part is taken for: the signs in x on [0, 1].
  SignsOnPart signs() const {
    auto copy = c;
    return signs_of(std::span<Int>(copy));
  }

  /// 2^(Degree·level) times this, in x, where t = (m + x)·2^-level.
  template <int PartBits>
  ShortPolynomial<Degree, PartBits> on_part(std::int64_t m, int level) const {
    ShortPolynomial<Degree, PartBits> r;
    for (std::size_t i = 0; i <= Degree; ++i) {
      r.c[i] = WideInt<PartBits>(c[i]) << static_cast<int>(Degree - i) * level;
    }
    for (std::size_t i = 0; i < Degree; ++i) {
      for (std::size_t j = Degree; j-- > i;) r.c[j] += r.c[j + 1] * m;
    }
    return r;
  }
};

/// What MovingPolygon is made of, for numbers of two limbs. All of it fits (DERIVATION.md, 7, L10).
struct ShortIntegers {
  static constexpr int kBits = 125;
  using Int = WideInt<128>;
  using Corner = ShortPolynomial<1, 128>;
  using Cross = ShortPolynomial<2, 256>;
  using Determinant = ShortPolynomial<3, 384>;
};

/// A ShortPolynomial in doubles, each within a relative error of 2^-52. A coefficient is 0,
/// or 1 at least in magnitude. rough_contact has no use for it.
template <int Degree>
struct RoughPolynomial {
  std::array<double, Degree + 1> c;

  template <int Bits>
  explicit RoughPolynomial(const ShortPolynomial<Degree, Bits>& p) {
    for (std::size_t i = 0; i <= Degree; ++i) c[i] = p.c[i].approximate();
  }

  /// The sign that the polynomial has on all of [x − radius, x + radius], if doubles tell (Law
  /// L10). Times are in [0, 1], and x is such a time, rounded: 0 ≤ x ≤ 1 + 2^-50. Requires x = 0 or
  /// x ≥ 2^-400. With radius = 0, x is a multiple of 2^-45: powers of less may underflow unseen.
  std::optional<int> sign_about(double x, double radius) const {
    double value = c[Degree], size = std::abs(c[Degree]), slope = Degree * size;
    for (std::size_t i = Degree; i-- > 0;) {
      value = value * x + c[i];
      size = size * x + std::abs(c[i]);
      slope += static_cast<double>(i) * std::abs(c[i]);
    }
    // Law L10: 2^-52 of each coefficient and six roundings, 2^-53 each, are 8·2^-53 of the size at
    // most. As much is for it and the slope, which are rounded too.
    const double bound = 0x1p-49 * size + 2 * radius * slope;
    if (value > bound) return 1;
    if (value < -bound) return -1;
    return bound == 0 ? std::optional(0) : std::nullopt;
  }
};

}  // namespace ccdfuzz::certified
