#include "certify/checker/nonnegative.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "certify/checker/copositive.hpp"

namespace ccdfuzz {

namespace {

/// Degree of the polynomial in v, or of a row of control points with this i.
int degree_in_v(const Shape& shape, int i) {
  return shape.kind == ShapeKind::kTriangle ? shape.n - i : shape.m;
}

bool all_nonnegative(const std::vector<Rational>& coefficients) {
  return std::ranges::all_of(coefficients, [](const Rational& c) { return c >= 0; });
}

Rational choose(int n, int k) {
  Rational value = 1;
  for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
  return value;
}

/// The coefficients of 1, u, v, u², uv and v²; nullopt if there are higher terms.
std::optional<std::array<Rational, 6>> low_terms(const Shape& shape, std::vector<Rational> c) {
  const auto at = [&](int i, int j) -> Rational& {
    return c[static_cast<size_t>(shape.index(i, j))];
  };
  // Forward differences Δu^i Δv^j at control point (0, 0), each in the place of (i, j).
  for (int round = 1; round <= shape.n; ++round) {
    for (int i = shape.n; i >= round; --i) {
      for (int j = 0; j <= degree_in_v(shape, i); ++j) at(i, j) -= at(i - 1, j);
    }
  }
  std::array<Rational, 6> terms;
  constexpr std::array<std::array<size_t, 3>, 3> kPlace = {{{0, 2, 5}, {1, 4, 6}, {3, 6, 6}}};
  for (int i = 0; i <= shape.n; ++i) {
    const int m = degree_in_v(shape, i);
    for (int round = 1; round <= m; ++round) {
      for (int j = m; j >= round; --j) at(i, j) -= at(i, j - 1);
    }
    for (int j = 0; j <= m; ++j) {
      if (at(i, j) == 0) continue;
      if (i + j > 2) return std::nullopt;
      // n!/(i!j!(n−i−j)!) = C(n,i)·C(n−i,j) on a triangle.
      terms[kPlace[static_cast<size_t>(i)][static_cast<size_t>(j)]] =
          at(i, j) * choose(shape.n, i) * choose(m, j);
    }
  }
  return terms;
}

using DomainCorner = std::array<int, 2>;

/// Whether the polynomial of these terms is ≥ 0 on the triangle of these corners.
bool nonnegative_between(const std::array<Rational, 6>& terms,
                         const std::array<DomainCorner, 3>& corners) {
  const auto polar = [&](const DomainCorner& p, const DomainCorner& q) {
    return Rational(terms[0] + terms[1] * (p[0] + q[0]) / 2 + terms[2] * (p[1] + q[1]) / 2 +
                    terms[3] * (p[0] * q[0]) + terms[4] * (p[0] * q[1] + p[1] * q[0]) / 2 +
                    terms[5] * (p[1] * q[1]));
  };
  const auto& [a, b, c] = corners;
  return nonnegative_on_triangle(std::array<Rational, 6>{polar(a, a), polar(a, b), polar(b, b),
                                                         polar(a, c), polar(b, c), polar(c, c)});
}

bool is_low_and_nonnegative(const Shape& shape, const std::vector<Rational>& coefficients) {
  const auto terms = low_terms(shape, coefficients);
  if (!terms) return false;
  const DomainCorner origin = {0, 0}, u = {1, 0}, v = {0, 1}, both = {1, 1};
  // What does not depend on v is ≥ 0 on [0, 1] iff it is so on the triangle.
  if (!nonnegative_between(*terms, {origin, v, u})) return false;
  return shape.kind != ShapeKind::kTensor || nonnegative_between(*terms, {both, v, u});
}

bool is_nonnegative_row(const std::vector<Rational>& row) {
  return all_nonnegative(row) ||
         is_low_and_nonnegative(Shape::curve(static_cast<int>(row.size()) - 1), row);
}

/// by_u: rows of equal i, else of equal j.
bool has_nonnegative_rows(const Shape& shape, const std::vector<Rational>& coefficients,
                          bool by_u) {
  const int rows = by_u ? shape.n : degree_in_v(shape, 0);
  for (int r = 0; r <= rows; ++r) {
    std::vector<Rational> row;
    const int last = by_u || shape.kind == ShapeKind::kTriangle ? degree_in_v(shape, r) : shape.n;
    for (int k = 0; k <= last; ++k) {
      row.push_back(
          coefficients[static_cast<size_t>(by_u ? shape.index(r, k) : shape.index(k, r))]);
    }
    if (!is_nonnegative_row(row)) return false;
  }
  return true;
}

/// The same polynomial with u and w = 1−u−v exchanged.
std::vector<Rational> turned(const Shape& triangle, const std::vector<Rational>& coefficients) {
  std::vector<Rational> out;
  for (int i = 0; i <= triangle.n; ++i) {
    for (int j = 0; j <= triangle.n - i; ++j) {
      out.push_back(coefficients[static_cast<size_t>(triangle.index(triangle.n - i - j, j))]);
    }
  }
  return out;
}

}  // namespace

bool is_nonnegative(const Shape& shape, const std::vector<Rational>& coefficients) {
  if (all_nonnegative(coefficients)) return true;
  if (shape.kind == ShapeKind::kPoint) return false;
  if (is_low_and_nonnegative(shape, coefficients)) return true;
  if (shape.kind == ShapeKind::kCurve) return false;
  if (has_nonnegative_rows(shape, coefficients, true) ||
      has_nonnegative_rows(shape, coefficients, false)) {
    return true;
  }
  return shape.kind == ShapeKind::kTriangle &&
         has_nonnegative_rows(shape, turned(shape, coefficients), true);
}

}  // namespace ccdfuzz
