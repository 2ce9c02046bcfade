#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"

namespace ccdfuzz {

enum class ShapeKind : std::uint8_t { kPoint, kCurve, kTriangle, kTensor, kHull };

inline constexpr int kMaxDegree = 8;
inline constexpr int kMaxControls = (kMaxDegree + 1) * (kMaxDegree + 1);

/// What a patch is, apart from its control points.
///
/// kind      degrees  control points    parameters
/// point     –        1                 –
/// curve     n        n+1               u in [0,1]
/// triangle  n        (n+1)(n+2)/2      u, v ≥ 0, u+v ≤ 1; the third barycentric is w = 1−u−v
/// tensor    n, m     (n+1)(m+1)        u, v in [0,1]
/// hull      –        n                 –
///
/// Control points are ordered i = 0..n (power of u), within it j = 0..n−i (triangle) or 0..m
/// (tensor) (power of v). Degrees are 1..kMaxDegree. A hull is a body: the convex hull of
/// 1..kMaxControls points in any order, which has no cells and no derivatives.
struct Shape {
  ShapeKind kind = ShapeKind::kPoint;
  int n = 0;  ///< a hull: the number of its points
  int m = 0;  ///< tensor only, else 0

  static constexpr Shape point() { return {}; }
  static constexpr Shape curve(int n) { return {ShapeKind::kCurve, n, 0}; }
  static constexpr Shape triangle(int n) { return {ShapeKind::kTriangle, n, 0}; }
  static constexpr Shape tensor(int n, int m) { return {ShapeKind::kTensor, n, m}; }
  static constexpr Shape hull(int n) { return {ShapeKind::kHull, n, 0}; }

  constexpr int control_count() const {
    if (kind == ShapeKind::kHull) return n;
    return kind == ShapeKind::kTriangle ? (n + 1) * (n + 2) / 2 : (n + 1) * (m + 1);
  }

  /// Place of control point (i, j) in the order above.
  constexpr int index(int i, int j) const {
    if (kind == ShapeKind::kTriangle) return i * (n + 1) - i * (i - 1) / 2 + j;
    return kind == ShapeKind::kTensor ? i * (m + 1) + j : i;
  }

  /// Row i of control points is (i, 0) to (i, last_column(i)), 0 ≤ i ≤ n. Not of a hull.
  constexpr int last_column(int i) const { return kind == ShapeKind::kTriangle ? n - i : m; }

  constexpr int parameter_count() const {
    const bool has_none = kind == ShapeKind::kPoint || kind == ShapeKind::kHull;
    return has_none ? 0 : kind == ShapeKind::kCurve ? 1 : 2;
  }

  /// How many congruent parts a midpoint split makes: 1, 2 or 4.
  constexpr int child_count() const { return 1 << parameter_count(); }

  /// True iff the degrees are in range for the kind.
  constexpr bool valid() const {
    const auto in_range = [](int d) { return 1 <= d && d <= kMaxDegree; };
    switch (kind) {
      case ShapeKind::kPoint:
        return n == 0 && m == 0;
      case ShapeKind::kCurve:
      case ShapeKind::kTriangle:
        return in_range(n) && m == 0;
      case ShapeKind::kTensor:
        return in_range(n) && in_range(m);
      case ShapeKind::kHull:
        return 1 <= n && n <= kMaxControls && m == 0;
    }
    return false;
  }

  /// True iff (u, v) lies in the domain; unused parameters must be 0.
  template <class S>
  bool contains(const std::array<S, 2>& uv) const {
    const S zero(0), one(1);
    for (int k = 0; k < 2; ++k) {
      const S& x = uv[static_cast<std::size_t>(k)];
      if (k < parameter_count() ? !(zero <= x && x <= one) : !(x == zero)) return false;
    }
    return kind != ShapeKind::kTriangle || uv[0] <= S(one - uv[1]);
  }

  friend constexpr bool operator==(const Shape&, const Shape&) = default;
};

/// Calls visit(i, j) for every control point of a patch, in the order above.
template <class Visit>
constexpr void for_each_control(const Shape& shape, const Visit& visit) {
  for (int i = 0; i <= shape.n; ++i) {
    for (int j = 0; j <= shape.last_column(i); ++j) visit(i, j);
  }
}

/// The binomial coefficient: of a Bernstein polynomial of degree n ≤ kMaxDegree, at most 70.
constexpr int choose(int n, int k) {
  int c = 1;
  for (int i = 0; i < k; ++i) c = c * (n - i) / (i + 1);
  return c;
}

/// Points, curves of degree 1 and triangles of degree 1, with at most two parameters in all. So:
/// vertex-face and edge-edge, and what they degenerate to.
constexpr bool is_linear_pair(const Shape& a, const Shape& b) {
  const auto flat = [](const Shape& s) { return s.kind < ShapeKind::kTensor && s.n <= 1; };
  return flat(a) && flat(b) && a.parameter_count() + b.parameter_count() <= 2;
}

constexpr std::array<std::string_view, 5> names_of(ShapeKind) {
  return {"point", "curve", "triangle", "tensor", "hull"};
}
/// "triangle(2)", "tensor(3,2)", …
std::string to_text(const Shape& shape);
/// For what is done with patches alone. Errors: throws InternalError.
[[noreturn]] void refuse_hull();

}  // namespace ccdfuzz
