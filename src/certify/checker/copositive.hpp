#pragma once

#include <array>
#include <cstddef>

namespace ccdfuzz {

/// True iff the quadratic polynomial with these six Bernstein coefficients, in the order of
/// Shape::triangle(2), is ≥ 0 on the whole triangle. That is, iff the symmetric 3×3 matrix they
/// form is copositive. Exact for exact S, complete, and without a square root.
///
/// Let A be the matrix. Necessary: its restrictions to the three edges are copositive. That is,
/// both diagonal entries are ≥ 0, and the other is ≥ 0 or its square is at most their product.
///
/// Given that, A is not copositive iff det A < 0 and adj A ≥ 0 in every entry:
///
/// (⇐) Then A⁻¹ = adj A / det A ≤ 0 and A⁻¹ ≠ 0. Take y = −A⁻¹1 ≥ 0, y ≠ 0: Ay = −1, and
///     yᵀAy = −Σy < 0.
/// (⇒) Let −μ < 0 be the least value of xᵀAx on the simplex, at x. It is not on an edge, so x > 0
/// and
///     Ax = −μ1, and A is positive semidefinite on {Σz = 0}.
///     A is regular: if Az = 0 with z ≠ 0, then 0 = zᵀAx = −μΣz, so x + sz stays in the plane of
///     the simplex with value −μ, and where it meets an edge it contradicts copositivity there. A
///     is ≥ 0 on a plane, regular, and negative at x, so its signature is (+,+,−): det A < 0. Let y
///     = A⁻¹eᵢ. If some y_j > 0, walk p = x − sy, s ≥ 0, up to the first p_j = 0. There pᵀAp = −μ −
///     2s xᵢ + s² yᵢ. If yᵢ ≤ 0 this is < 0. If yᵢ > 0 it falls as long as s < xᵢ/yᵢ, which is as
///     far as pᵢ stays positive; so it is < 0 too. p ≥ 0 has a zero, and p ≠ 0 as pᵀAp ≠ 0: a
///     contradiction on an edge. Hence A⁻¹ ≤ 0, and adj A = det A · A⁻¹ ≥ 0.
template <class S>
bool nonnegative_on_triangle(const std::array<S, 6>& heights) {
  constexpr std::array<std::array<std::size_t, 3>, 3> place = {{{5, 4, 3}, {4, 2, 1}, {3, 1, 0}}};
  const auto at = [&](std::size_t a, std::size_t b) -> const S& { return heights[place[a][b]]; };
  bool all_nonnegative = true;
  for (const S& h : heights) all_nonnegative &= h >= 0;
  if (all_nonnegative) return true;

  for (std::size_t a = 0; a < 3; ++a) {
    if (at(a, a) < 0) return false;
    const std::size_t b = (a + 1) % 3;
    if (at(a, b) < 0 && S(at(a, b) * at(a, b)) > S(at(a, a) * at(b, b))) return false;
  }
  // Entry (a, b) of the adjugate, by cyclic indices, which take care of the signs.
  const auto adjugate = [&](std::size_t a, std::size_t b) {
    const std::size_t a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
    return S(at(a1, b1) * at(a2, b2) - at(a1, b2) * at(a2, b1));
  };
  S det(0);
  for (std::size_t b = 0; b < 3; ++b) det += at(0, b) * adjugate(0, b);
  if (det >= 0) return true;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      if (adjugate(a, b) < 0) return true;
    }
  }
  return false;
}

}  // namespace ccdfuzz
