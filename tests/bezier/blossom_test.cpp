#include "bezier/blossom.hpp"

#include "bezier/random_patch.hpp"
#include "bezier/restrict.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {
namespace {

long binomial(int n, int k) {
  return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k;
}

Dyadic power(const Dyadic& x, int e) {
  return e == 0 ? Dyadic(1) : x * power(x, e - 1);
}

/// The patch by its definition: the sum of Bernstein weights times control points (Eq. 2).
Vec3<Dyadic> by_definition(const Shape& shape, const Points<Dyadic>& points, const Uv<Dyadic>& uv) {
  const auto& [u, v] = uv;
  Vec3<Dyadic> sum = {Dyadic(), Dyadic(), Dyadic()};
  const auto add = [&](int i, int j, const Dyadic& weight) {
    for (int k = 0; k < 3; ++k) sum[k] += weight * points[shape.index(i, j)][k];
  };
  const auto bernstein = [](int n, int i, const Dyadic& x) {
    return Dyadic(Integer(binomial(n, i)), 0) * power(x, i) * power(Dyadic(1) - x, n - i);
  };
  switch (shape.kind) {
    case ShapeKind::kHull:
      refuse_hull();
    case ShapeKind::kPoint:
      return points[0];
    case ShapeKind::kCurve:
      for (int i = 0; i <= shape.n; ++i) add(i, 0, bernstein(shape.n, i, u));
      break;
    case ShapeKind::kTriangle:
      for (int i = 0; i <= shape.n; ++i) {
        for (int j = 0; j <= shape.n - i; ++j) {
          add(i, j,
              Dyadic(Integer(binomial(shape.n, i) * binomial(shape.n - i, j)), 0) * power(u, i) *
                  power(v, j) * power(Dyadic(1) - u - v, shape.n - i - j));
        }
      }
      break;
    case ShapeKind::kTensor:
      for (int i = 0; i <= shape.n; ++i) {
        for (int j = 0; j <= shape.m; ++j)
          add(i, j, bernstein(shape.n, i, u) * bernstein(shape.m, j, v));
      }
  }
  return sum;
}

RC_GTEST_PROP(Evaluate, IsTheBernsteinSum, ()) {
  const Shape shape = *any_shape();
  const Points<Dyadic> points = any_points(shape);
  const Uv<Dyadic> uv = any_uv(shape);
  RC_ASSERT(evaluate<Dyadic>(shape, points, uv) == by_definition(shape, points, uv));
}

RC_GTEST_PROP(Blossom, IsSymmetricAndAffineInEachArgument, ()) {
  const Shape shape = *any_shape();
  const Points<Dyadic> points = any_points(shape);
  std::array<Uv<Dyadic>, kMaxDegree> a;
  for (auto& uv : a) uv = any_uv(shape);
  const auto value = [&] { return blossom<Dyadic>(shape, points, a); };
  const Vec3<Dyadic> at_a = value();
  if (shape.n >= 2 && (shape.kind != ShapeKind::kTensor || shape.m >= 2)) {
    std::swap(a[0], a[1]);
    RC_ASSERT(value() == at_a);
  }
  const Uv<Dyadic> p = a[0], q = any_uv(shape);
  const Vec3<Dyadic> at_p = value();
  a[0] = q;
  const Vec3<Dyadic> at_q = value();
  a[0] = {(p[0] + q[0]).scaled(-1), (p[1] + q[1]).scaled(-1)};
  const Vec3<Dyadic> at_mid = value();
  if (shape.kind == ShapeKind::kTensor) return;  // affine in u and in v apart, not in both at once
  for (int k = 0; k < 3; ++k) RC_ASSERT(at_mid[k] == (at_p[k] + at_q[k]).scaled(-1));
}

TEST(RationalPatch, OfWeightsOneOneTwoIsAQuarterCircle) {
  const MovingPatch<Rational> arc{Shape::curve(2),
                                  {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                  {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                                  {},
                                  {1, 1, 2}};
  const std::array<Uv<Rational>, 3> corners = {{{Rational(1, 4), 0}, {Rational(1, 2), 0}, {0, 0}}};
  const MovingPatch<Rational> part = restrict_to(arc, corners);
  for (int i = 0; i <= 16; ++i) {
    const Rational u = Rational(i) / 16;
    const Vec3<Rational> p = evaluate<Rational>(arc, {u, 0}, 3);
    EXPECT_EQ(p[0] * p[0] + p[1] * p[1], 1);
    EXPECT_EQ(p[0] * (1 + u * u), 1 - u * u);
    EXPECT_EQ(p[2], 3);
    EXPECT_EQ(evaluate<Rational>(part, {u, 0}, 3),
              evaluate<Rational>(arc, {Rational((1 + u) / 4), 0}, 3));
  }
}

}  // namespace
}  // namespace ccdfuzz
