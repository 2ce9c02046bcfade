#include "generators/copositive.hpp"

namespace ccdfuzz {

// Let A be the matrix. Necessary: its restrictions to the three edges are copositive, that is, both
// diagonal entries are ≥ 0 and the other is ≥ 0 or its square is at most their product.
//
// Given that, A is not copositive iff det A < 0 and adj A ≥ 0 in every entry:
//
// (⇐) Then A⁻¹ = adj A / det A ≤ 0 and A⁻¹ ≠ 0. Take y = −A⁻¹1 ≥ 0, y ≠ 0: Ay = −1, and
//     yᵀAy = −Σy < 0.
// (⇒) Let −μ < 0 be the least value of xᵀAx on the simplex, at x. It is not on an edge, so x > 0
// and
//     Ax = −μ1, and A is positive semidefinite on {Σz = 0}.
//     A is regular: if Az = 0 with z ≠ 0, then 0 = zᵀAx = −μΣz, so x + sz stays in the plane of the
//     simplex with value −μ, and where it meets an edge it contradicts copositivity there.
//     A is ≥ 0 on a plane, regular, and negative at x, so its signature is (+,+,−): det A < 0.
//     Let y = A⁻¹eᵢ. If some y_j > 0, walk p = x − sy, s ≥ 0, up to the first p_j = 0. There
//     pᵀAp = −μ − 2s xᵢ + s² yᵢ. If yᵢ ≤ 0 this is < 0. If yᵢ > 0 it falls as long as s < xᵢ/yᵢ,
//     which is as far as pᵢ stays positive; so it is < 0 too. p ≥ 0 has a zero, and p ≠ 0 as
//     pᵀAp ≠ 0: a contradiction on an edge. Hence A⁻¹ ≤ 0, and adj A = det A · A⁻¹ ≥ 0.
bool nonnegative_on_triangle(const std::array<Dyadic, 6>& heights) {
  const auto at = [&](int a, int b) -> const Dyadic& { return heights[control_of(a, b)]; };
  bool all_nonnegative = true;
  for (const Dyadic& h : heights) all_nonnegative &= h.sign() >= 0;
  if (all_nonnegative) return true;

  for (int a = 0; a < 3; ++a) {
    if (at(a, a).sign() < 0) return false;
    const int b = (a + 1) % 3;
    if (at(a, b).sign() < 0 && at(a, b) * at(a, b) > at(a, a) * at(b, b)) return false;
  }
  // Entry (a, b) of the adjugate, by cyclic indices, which take care of the signs.
  const auto adjugate = [&](int a, int b) {
    const int a1 = (a + 1) % 3, a2 = (a + 2) % 3, b1 = (b + 1) % 3, b2 = (b + 2) % 3;
    return at(a1, b1) * at(a2, b2) - at(a1, b2) * at(a2, b1);
  };
  Dyadic det;
  for (int b = 0; b < 3; ++b) det += at(0, b) * adjugate(0, b);
  if (det.sign() >= 0) return true;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      if (adjugate(a, b).sign() < 0) return true;
    }
  }
  return false;
}

}  // namespace ccdfuzz
