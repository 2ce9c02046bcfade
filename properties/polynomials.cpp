#include <algorithm>
#include <optional>

#include "certify/checker/nonnegative.hpp"
#include "generators/draw_patch.hpp"
#include "generators/shaped/heights.hpp"
#include "properties/show.hpp"

namespace ccdfuzz {

namespace {

/// factor·u^a·v^b.
struct Monomial {
  int a, b;
  Rational factor;
};
using Polynomial = std::vector<Monomial>;

/// Whether the shape has a polynomial of that term, and so of its Bernstein coefficients.
bool has_term(const Shape& shape, int a, int b) {
  return shape.kind == ShapeKind::kTriangle ? a + b <= shape.n : a <= shape.n && b <= shape.m;
}

/// In Shape's order.
std::vector<Rational> coefficients_of(const Shape& shape, const Polynomial& polynomial) {
  std::vector<Rational> out;
  for_each_control(shape, [&](int i, int j) {
    Rational sum = 0;
    for (const auto& [a, b, factor] : polynomial) {
      sum += factor * coefficient_of(shape, i, j, a, b);
    }
    out.push_back(sum);
  });
  return out;
}

Rational value_at(const Polynomial& polynomial, const Uv<Rational>& at) {
  Rational sum = 0;
  for (const auto& [a, b, factor] : polynomial) {
    Rational term = factor;
    for (int k = 0; k < a; ++k) term *= at[0];
    for (int k = 0; k < b; ++k) term *= at[1];
    sum += term;
  }
  return sum;
}

/// Where a quadratic is least inside of the domain: where both derivatives are 0, if it is convex
/// both ways there. If it is convex one way only and flat the other, it is as low on the boundary.
std::optional<Uv<Rational>> least_inside(const Shape& shape, const Polynomial& quadratic) {
  const auto factor = [&](int a, int b) {
    Rational sum = 0;
    for (const Monomial& m : quadratic) {
      if (m.a == a && m.b == b) sum += m.factor;
    }
    return sum;
  };
  const Rational uu = factor(2, 0), uv = factor(1, 1), vv = factor(0, 2);
  const Rational u = factor(1, 0), v = factor(0, 1);
  const Rational determinant = 4 * uu * vv - uv * uv;
  if (determinant <= 0 || uu <= 0) return std::nullopt;
  const Uv<Rational> at = {Rational((uv * v - 2 * vv * u) / determinant),
                           Rational((uv * u - 2 * uu * v) / determinant)};
  if (!shape.contains(at)) return std::nullopt;
  return at;
}

/// The least value of a polynomial of total degree at most 2 on the domain.
Rational least_of_quadratic(const Shape& shape, const Polynomial& quadratic) {
  Rational least = value_at(quadratic, {0, 0});
  for (const ShapeEdge& edge : edges_of(shape)) {
    const auto along = [&](const Rational& s) {
      const auto& [p, way] = edge;
      return value_at(quadratic, {Rational(p[0] + s * way[0]), Rational(p[1] + s * way[1])});
    };
    // value + slope·s + bend·s² on the edge
    const Rational value = along(0), end = along(1);
    const Rational bend = 2 * (value + end - 2 * along(Rational(1, 2)));
    const Rational slope = end - value - bend;
    least = std::min({least, value, end});
    if (bend <= 0) continue;
    const Rational lowest = -slope / (2 * bend);
    if (0 < lowest && lowest < 1) least = std::min(least, along(lowest));
  }
  if (const auto at = least_inside(shape, quadratic)) {
    least = std::min(least, value_at(quadratic, *at));
  }
  return least;
}

/// All terms up to a degree that the shape has, with small integer factors, and none of degree 0.
Polynomial draw_terms(Draw& choices, const Shape& shape, int max_degree) {
  constexpr int kLargest = 4;
  Polynomial drawn;
  for (int degree = 1; degree <= max_degree; ++degree) {
    for (int b = 0; b <= degree; ++b) {
      if (!has_term(shape, degree - b, b)) continue;
      const int factor = choices.integer(-kLargest, kLargest);
      drawn.push_back({degree - b, b, factor});
    }
  }
  return drawn;
}

/// From 1 down to where a sum with the numbers drawn here would be rounded in doubles.
Rational draw_little(Draw& choices) {
  constexpr int kFinest = -60;
  return power_of_two(choices.integer(kFinest, 0));
}

/// How far above 0 the least value is to be.
Rational draw_gap(Draw& choices, int least) {
  const int units = choices.integer(least, 1);
  return units * draw_little(choices);
}

bool is_seen(Draw& d, const Shape& shape, const std::vector<Rational>& coefficients) {
  show(d, "shape", shape);
  show(d, "coefficients", coefficients);
  return is_nonnegative(shape, coefficients);
}

void check_quadratics(Draw& d) {
  constexpr int kMaxShapeDegree = 3;
  const Shape shape = draw_shape(d, kMaxShapeDegree);
  Polynomial drawn = draw_terms(d, shape, 2);
  const Rational least = show(d, "least", draw_gap(d, -1));
  const Rational constant = least - least_of_quadratic(shape, drawn);
  drawn.push_back({0, 0, constant});
  CLAIM(is_seen(d, shape, coefficients_of(shape, drawn)) == (least >= 0));
}

/// Negative at a point of a lattice.
void check_negative_somewhere(Draw& d) {
  constexpr int kMaxShapeDegree = 3, kSteps = 4;
  const Shape shape = draw_shape(d, kMaxShapeDegree);
  Polynomial drawn = draw_terms(d, shape, shape.n + shape.m);
  std::optional<Rational> least;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Uv<Rational> at = {Rational(i) / kSteps, Rational(j) / kSteps};
      if (!shape.contains(at)) continue;
      const Rational value = value_at(drawn, at);
      if (!least || value < *least) least = value;
    }
  }
  const Rational below = draw_little(d);
  const Rational constant = -*least - below;
  drawn.push_back({0, 0, constant});
  CLAIM(!is_seen(d, shape, coefficients_of(shape, drawn)));
}

/// A polynomial in one variable that is ≥ 0 on [0, 1], of whichever kind is_nonnegative promises
/// to see, by its coefficients.
std::vector<Rational> draw_row(Draw& choices, int degree) {
  constexpr int kLargest = 4;
  if (degree < 2 || choices.coin()) {
    std::vector<Rational> row;
    for (int k = 0; k <= degree; ++k) {
      row.emplace_back(choices.integer(0, kLargest));
    }
    return row;
  }
  const Shape curve = Shape::curve(degree);
  Polynomial drawn = draw_terms(choices, curve, 2);
  const Rational constant = draw_gap(choices, 0) - least_of_quadratic(curve, drawn);
  drawn.push_back({0, 0, constant});
  return coefficients_of(curve, drawn);
}

/// Rows along u, v or, on a triangle, its third edge.
void check_rows(Draw& d) {
  constexpr int kMostDegree = 4;
  const bool triangle = d.coin();
  const int n = d.integer(1, kMostDegree);
  const int m = d.integer(1, kMostDegree);
  const Shape shape = triangle ? Shape::triangle(n) : Shape::tensor(n, m);
  const std::uint64_t direction = d.choose(triangle ? 2 : 1);
  std::vector<Rational> coefficients(static_cast<std::size_t>(shape.control_count()));
  const int rows = direction == 1 && !triangle ? shape.m : shape.n;
  for (int r = 0; r <= rows; ++r) {
    const int degree = triangle ? shape.n - r : shape.n + shape.m - rows;
    const std::vector<Rational> row = draw_row(d, degree);
    for (int k = 0; k <= degree; ++k) {
      const int place = direction == 0   ? shape.index(r, k)
                        : direction == 1 ? shape.index(k, r)
                                         : shape.index(shape.n - r - k, k);
      coefficients[static_cast<std::size_t>(place)] = row[static_cast<std::size_t>(k)];
    }
  }
  CLAIM(is_seen(d, shape, coefficients));
}

Rational draw_inside(Draw& choices) {
  return Rational(choices.integer(1, 7)) / 8;
}

void exchange_parameters(Polynomial& polynomial) {
  for (Monomial& m : polynomial) std::swap(m.a, m.b);
}

/// α·(v − a)² + (β + γ·v)·(u − b)², of which all of α, β, γ are ≥ 0 and the first two above, is 0
/// at (b, a) alone. It is seen to be ≥ 0. That less anything is not, nor that times −1.
void check_discriminants(Draw& d) {
  const auto factor = [&](int least) { return Rational(d.integer(least, 4)); };
  const Rational a = draw_inside(d), b = draw_inside(d), alpha = factor(1), beta = factor(1);
  const Rational gamma = factor(0);
  const bool is_turned = d.coin();
  Polynomial drawn;
  const auto add = [&](int in_u, int in_v, const Rational& by) {
    drawn.push_back({in_u, in_v, by});
  };
  add(0, 2, alpha), add(0, 1, -2 * a * alpha), add(0, 0, a * a * alpha);
  for (const int v : {0, 1}) {
    const Rational& by = v == 0 ? beta : gamma;
    add(2, v, by), add(1, v, -2 * b * by), add(0, v, b * b * by);
  }
  if (is_turned) exchange_parameters(drawn);
  const Shape shape = Shape::tensor(2, 2);
  CLAIM(is_seen(d, shape, coefficients_of(shape, drawn)));
  Polynomial negative = drawn;
  for (Monomial& m : negative) m.factor = -m.factor;
  CLAIM(!is_seen(d, shape, coefficients_of(shape, negative)));
  drawn.push_back({0, 0, -draw_little(d)});
  CLAIM(!is_seen(d, shape, coefficients_of(shape, drawn)));
}

/// α·((v − a)³ + 64·(u − b)²) is negative at u = b and v < a. Its outer rows are ≥ 0, since b² and
/// (1 − b)² are at least 1/64. Its discriminant has a factor three times.
void check_cubes(Draw& d) {
  const Rational a = draw_inside(d), b = draw_inside(d), alpha = draw_little(d);
  const bool is_turned = d.coin();
  Polynomial drawn = {{0, 3, 1},  {0, 2, -3 * a},   {0, 1, 3 * a * a}, {0, 0, -a * a * a},
                      {2, 0, 64}, {1, 0, -128 * b}, {0, 0, 64 * b * b}};
  for (Monomial& m : drawn) m.factor *= alpha;
  if (is_turned) exchange_parameters(drawn);
  const Shape shape = is_turned ? Shape::tensor(3, 2) : Shape::tensor(2, 3);
  CLAIM(!is_seen(d, shape, coefficients_of(shape, drawn)));
}

}  // namespace

std::vector<Property> polynomials_claims() {
  constexpr auto kSource = "src/certify/checker/nonnegative.hpp";
  return {
      {"checker.decides_quadratics",
       "A polynomial of total degree at most 2 is seen to be >= 0 iff its least value is, among "
       "those of corners, edges and where it is level",
       kSource, check_quadratics},
      {"checker.refuses_negative_polynomials",
       "No polynomial of any degree that is negative at a point is taken for one that is >= 0",
       kSource, check_negative_somewhere},
      {"checker.sees_nonnegative_rows",
       "A polynomial whose rows along either parameter, or any edge of a triangle, are >= 0 is "
       "seen to be so",
       kSource, check_rows},
      {"checker.sees_discriminants",
       "A sum of squares along both parameters is seen to be >= 0, and no less is", kSource,
       check_discriminants},
      {"checker.refuses_cubes",
       "A polynomial whose discriminant has a factor three times is not taken for one that is >= 0",
       kSource, check_cubes},
  };
}

}  // namespace ccdfuzz
