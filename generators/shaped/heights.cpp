#include "generators/shaped/heights.hpp"

#include <algorithm>
#include <numeric>

#include "base/verify.hpp"

namespace ccdfuzz {

namespace {

constexpr int kFactorSlopeBits = 2;  // of the linear factors of a height

/// x·(x − 1)·… with this many factors.
Rational falling(int x, int factors) {
  Rational product = 1;
  for (int k = 0; k < factors; ++k) product *= x - k;
  return product;
}

Linear random_linear_through(const Uv<Dyadic>& at, bool in_u, bool in_v, Draw& draw) {
  Linear p = draw.until(
      [&] {
        Linear slopes;
        if (in_u) slopes[1] = draw.lattice(kFactorSlopeBits, 0);
        if (in_v) slopes[2] = draw.lattice(kFactorSlopeBits, 0);
        return slopes;
      },
      [](const Linear& l) { return l[1].sign() != 0 || l[2].sign() != 0; });
  p[0] = -(p[1] * at[0] + p[2] * at[1]);
  return p;
}

bool is_parallel(const Linear& p, const Linear& q) {
  return (p[1] * q[2] - p[2] * q[1]).sign() == 0;
}

/// Heights over an inner point of a face, of the form p² or p² + q².
std::vector<Dyadic> over_face(const Shape& shape, const Uv<Dyadic>& at, ZeroSet zeros, Draw& draw) {
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  const bool in_u = shape.n >= 2, in_v = triangle ? in_u : shape.m >= 2;
  if (!in_u && !in_v) return std::vector<Dyadic>(static_cast<size_t>(shape.control_count()));
  const Linear p = random_linear_through(at, in_u, in_v, draw);
  LowPolynomial h = product(p, p);
  if (zeros == ZeroSet::kPoint && in_u && in_v) {
    const Linear q = draw.until([&] { return random_linear_through(at, true, true, draw); },
                                [&](const Linear& l) { return !is_parallel(p, l); });
    h = sum(h, product(q, q));
  }
  return coefficients_on(shape, h);
}

/// Heights over a point of an edge or a corner: positive but for the edge or the corner itself.
std::vector<Dyadic> over_boundary(const Shape& shape, const Uv<Dyadic>& at, ZeroSet zeros,
                                  Draw& draw) {
  std::vector<Dyadic> heights;
  for (int i = 0; i < shape.control_count(); ++i) {
    heights.emplace_back(draw.integer(1, 1 << (2 * kFactorSlopeBits + 2)));
  }
  const std::vector<ShapeEdge> edges = edges_through(shape, at);
  const bool on_corner = feature_at(shape, at) == Feature::kCorner;
  if (edges.empty() || (on_corner && zeros == ZeroSet::kPoint)) {
    for_each_control(shape, [&](int i, int j) {
      if (bears(shape, at, i, j)) heights[static_cast<size_t>(shape.index(i, j))] = Dyadic();
    });
    return heights;
  }
  const ShapeEdge& edge = edges[draw.below(edges.size())];
  std::vector<Dyadic> along(heights.size());
  if (zeros == ZeroSet::kPoint && edge.degree(shape) >= 2) {
    const bool in_u = edge.direction[0] != 0;
    const Linear p = random_linear_through(at, in_u, !in_u, draw);
    along = coefficients_on(shape, product(p, p));
  }
  for (const size_t place : edge.controls(shape)) heights[place] = along[place];
  return heights;
}

}  // namespace

Rational coefficient_of(const Shape& shape, int i, int j, int a, int b) {
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  const Rational whole =
      triangle ? falling(shape.n, a + b) : Rational(falling(shape.n, a) * falling(shape.m, b));
  return falling(i, a) * falling(j, b) / whole;
}

LowPolynomial product(const Linear& p, const Linear& q) {
  return {p[0] * q[0], p[0] * q[1] + p[1] * q[0], p[0] * q[2] + p[2] * q[0],
          p[1] * q[1], p[1] * q[2] + p[2] * q[1], p[2] * q[2]};
}

LowPolynomial sum(LowPolynomial p, const LowPolynomial& q) {
  for (size_t k = 0; k < p.size(); ++k) p[k] += q[k];
  return p;
}

Dyadic odd_denominator(const Shape& shape) {
  const int in_v = shape.kind == ShapeKind::kTriangle ? shape.n : std::max(1, shape.m);
  const int n = std::max(1, shape.n);
  int common = n * in_v;
  for (const int k : {n, in_v}) common = std::lcm(common, k * std::max(1, k - 1));
  while (common % 2 == 0) common /= 2;
  return {common};
}

std::vector<Dyadic> coefficients_on(const Shape& shape, const LowPolynomial& p) {
  constexpr std::array<std::array<int, 2>, 6> kPowers = {
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  const Rational scale = odd_denominator(shape).rational();
  std::vector<Dyadic> coefficients;
  for_each_control(shape, [&](int i, int j) {
    Dyadic value;
    for (size_t k = 0; k < p.size(); ++k) {
      if (p[k].sign() == 0) continue;
      const auto [a, b] = kPowers[k];
      const auto weight = Dyadic::from(scale * coefficient_of(shape, i, j, a, b));
      CCDFUZZ_VERIFY(weight);
      value += p[k] * *weight;
    }
    coefficients.push_back(value);
  });
  return coefficients;
}

std::vector<Dyadic> heights_over(const Shape& shape, const Uv<Dyadic>& at, ZeroSet zeros, long unit,
                                 Draw& draw) {
  std::vector<Dyadic> heights(static_cast<size_t>(shape.control_count()));
  if (zeros == ZeroSet::kAll || shape.kind == ShapeKind::kPoint) return heights;
  heights = feature_at(shape, at) == Feature::kFace ? over_face(shape, at, zeros, draw)
                                                    : over_boundary(shape, at, zeros, draw);
  for (Dyadic& h : heights) h = h.scaled(unit);
  return heights;
}

}  // namespace ccdfuzz
