#include "certify/checker/nonnegative.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "certify/checker/copositive.hpp"

namespace ccdfuzz {

namespace {

bool all_nonnegative(const std::vector<Rational>& coefficients) {
  return std::ranges::all_of(coefficients, [](const Rational& c) { return c >= 0; });
}

/// The coefficients of 1, u, v, u², uv and v²; nullopt if there are higher terms.
std::optional<std::array<Rational, 6>> low_terms(const Shape& shape, std::vector<Rational> c) {
  const auto at = [&](int i, int j) -> Rational& {
    return c[static_cast<size_t>(shape.index(i, j))];
  };
  // Forward differences Δu^i Δv^j at control point (0, 0), each in the place of (i, j).
  for (int round = 1; round <= shape.n; ++round) {
    for (int i = shape.n; i >= round; --i) {
      for (int j = 0; j <= shape.last_column(i); ++j) at(i, j) -= at(i - 1, j);
    }
  }
  std::array<Rational, 6> terms;
  constexpr std::array<std::array<size_t, 3>, 3> kPlace = {{{0, 2, 5}, {1, 4, 6}, {3, 6, 6}}};
  for (int i = 0; i <= shape.n; ++i) {
    const int m = shape.last_column(i);
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

/// Row r: of equal i, of equal j, or on a triangle of equal n − i − j, by 0, 1 or 2.
std::vector<Rational> row_of(const Shape& shape, const std::vector<Rational>& coefficients,
                             size_t by, int r) {
  std::vector<Rational> row;
  const int last = by == 0 || shape.kind == ShapeKind::kTriangle ? shape.last_column(r) : shape.n;
  for (int k = 0; k <= last; ++k) {
    const int place = by == 0   ? shape.index(r, k)
                      : by == 1 ? shape.index(k, r)
                                : shape.index(shape.n - r - k, k);
    row.push_back(coefficients[static_cast<size_t>(place)]);
  }
  return row;
}

/// A polynomial in one variable x: Bernstein coefficients times binomials, which are coefficients
/// in y = x/(1−x). So a product of two is one of these numbers alone, and x in [0, 1] is y ≥ 0.
using Scaled = std::vector<Rational>;

Scaled scaled(const std::vector<Rational>& row) {
  Scaled out;
  const int n = static_cast<int>(row.size()) - 1;
  for (int k = 0; k <= n; ++k) out.emplace_back(row[static_cast<size_t>(k)] * choose(n, k));
  return out;
}

Scaled product(const Scaled& a, const Scaled& b) {
  Scaled out(a.size() + b.size() - 1);
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  }
  return out;
}

void drop_zeros(Scaled& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

/// Divides by b, of which the last coefficient is not 0: a becomes the remainder.
Scaled divide(Scaled& a, const Scaled& b, Work* work) {
  Scaled quotient(a.size() >= b.size() ? a.size() - b.size() + 1 : 0);
  for (size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = a[i + b.size() - 1] / b.back();
    for (size_t k = 0; k < b.size(); ++k) {
      if (work != nullptr) {
        work->charge(2 *
                     fraction_work(words_of(a[i + k]) + words_of(quotient[i]) + words_of(b[k])));
      }
      a[i + k] -= quotient[i] * b[k];
    }
  }
  drop_zeros(a);
  return quotient;
}

/// The greatest common divisor of p ≠ 0 and its derivative.
Scaled repeated_factor(const Scaled& p, Work* work) {
  Scaled a = p, b;
  for (size_t k = 1; k < p.size(); ++k) b.emplace_back(p[k] * static_cast<long>(k));
  drop_zeros(b);
  while (!b.empty()) {
    divide(a, b, work);
    std::swap(a, b);
  }
  return a;
}

/// Whether p ≥ 0 for y ≥ 0 is seen: of coefficients ≥ 0, of degree 2, or of q·g² with such a q.
bool is_nonnegative_beyond_0(Scaled p, Work* work) {
  const auto is_simple = [](const Scaled& q) {
    if (all_nonnegative(q)) return true;
    if (q.size() != 3 || q[0] < 0 || q[2] < 0) return false;
    return q[1] * q[1] <= 4 * q[0] * q[2];
  };
  drop_zeros(p);
  if (is_simple(p)) return true;
  const Scaled g = repeated_factor(p, work);
  const Scaled q = divide(p, product(g, g), work);
  return p.empty() && is_simple(q);
}

/// The outer rows of three and their discriminant are ≥ 0.
bool has_nonnegative_discriminant(const std::array<std::vector<Rational>, 3>& rows, Work* work) {
  if (!is_nonnegative_row(rows[0]) || !is_nonnegative_row(rows[2])) return false;
  Scaled discriminant = product(scaled(rows[0]), scaled(rows[2]));
  const Scaled squared = product(scaled(rows[1]), scaled(rows[1]));
  for (size_t k = 0; k < squared.size(); ++k) discriminant[k] -= squared[k];
  return is_nonnegative_beyond_0(std::move(discriminant), work);
}

}  // namespace

bool is_nonnegative(const Shape& shape, const std::vector<Rational>& coefficients, Work* work) {
  if (all_nonnegative(coefficients)) return true;
  if (shape.kind == ShapeKind::kPoint) return false;
  if (is_low_and_nonnegative(shape, coefficients)) return true;
  if (shape.kind == ShapeKind::kCurve) return false;
  const auto row = [&](size_t by, int r) { return row_of(shape, coefficients, by, r); };
  const auto has_rows = [&](size_t by) {
    const int last = by == 0 ? shape.n : shape.last_column(0);
    for (int r = 0; r <= last; ++r) {
      if (!is_nonnegative_row(row(by, r))) return false;
    }
    return true;
  };
  if (has_rows(0) || has_rows(1)) return true;
  if (shape.kind == ShapeKind::kTriangle) return has_rows(2);
  const auto has_discriminant = [&](size_t by) {
    if ((by == 0 ? shape.n : shape.m) != 2) return false;
    return has_nonnegative_discriminant({row(by, 0), row(by, 1), row(by, 2)}, work);
  };
  return has_discriminant(0) || has_discriminant(1);
}

}  // namespace ccdfuzz
