#include "eval/curvature.hpp"

#include <cmath>

#include "bezier/blossom.hpp"
#include "certify/checker/polar.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

using ExactWeights = Weights<Rational>;

/// A surface's first and second derivatives at a point: u, v, uu, uv, vv.
using Derivatives = std::array<Vec3<double>, 5>;

Vec3<double> rounded_at(const Moving<Rational>& p, const Rational& t, int factor) {
  Vec3<double> out;
  for (size_t k = 0; k < 3; ++k) {
    out[static_cast<int>(k)] = Rational(factor * Rational(p[k] + t * p[k + 3])).get_d();
  }
  return out;
}

/// A derivative is the blossom with a direction for each differentiation, times n(n−1)….
class Differentiator {
 public:
  Differentiator(const MovingPatch<double>& patch, const Uv<Rational>& uv, const Rational& t)
      : shape_(patch.shape), net_(moving_net<Rational>(patch)), uv_(uv), t_(t) {}

  Derivatives run() { return shape_.kind == ShapeKind::kTriangle ? triangle() : tensor(); }

 private:
  Derivatives triangle() {
    const ExactWeights u = {-1, 1, 0}, v = {-1, 0, 1};
    const ExactWeights at = {Rational(1 - uv_[0] - uv_[1]), uv_[0], uv_[1]};
    const auto along = [&](const std::vector<ExactWeights>& directions) {
      const auto count = static_cast<int>(directions.size());
      if (count > shape_.n) return Vec3<double>(0, 0, 0);
      std::vector<ExactWeights> arguments(static_cast<size_t>(shape_.n), at);
      std::copy(directions.begin(), directions.end(), arguments.begin());
      const int factor = count == 1 ? shape_.n : shape_.n * (shape_.n - 1);
      return rounded_at(polar_(shape_, net_, arguments, {}), t_, factor);
    };
    return {along({u}), along({v}), along({u, u}), along({u, v}), along({v, v})};
  }

  Derivatives tensor() {
    const ExactWeights direction = {-1, 1, 0};
    const auto along = [&](int in_u, int in_v) {
      if (in_u > shape_.n || in_v > shape_.m) return Vec3<double>(0, 0, 0);
      int factor = 1;
      const auto arguments = [&](int degree, const Rational& at, int directions) {
        std::vector<ExactWeights> all(static_cast<size_t>(degree), {Rational(1 - at), at, 0});
        for (int i = 0; i < directions; ++i) {
          all[static_cast<size_t>(i)] = direction;
          factor *= degree - i;
        }
        return all;
      };
      const std::vector<ExactWeights> u = arguments(shape_.n, uv_[0], in_u);
      const std::vector<ExactWeights> v = arguments(shape_.m, uv_[1], in_v);
      return rounded_at(polar_(shape_, net_, u, v), t_, factor);
    };
    return {along(1, 0), along(0, 1), along(2, 0), along(1, 1), along(0, 2)};
  }

  Shape shape_;
  MovingNet<Rational> net_;
  Uv<Rational> uv_;
  Rational t_;
  Polar<Rational> polar_;
};

}  // namespace

double Curvature::rms() const {
  return std::hypot(kappa[0], kappa[1]) / std::sqrt(2.0);
}

std::optional<Curvature> curvature_at(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                                      const Rational& t) {
  const ShapeKind kind = patch.shape.kind;
  const bool is_surface = kind == ShapeKind::kTriangle || kind == ShapeKind::kTensor;
  if (!is_surface || patch.is_rational()) return std::nullopt;
  const auto [su, sv, suu, suv, svv] = Differentiator(patch, uv, t).run();
  const Vec3<double> across = cross(su, sv);
  const double length = std::hypot(across[0], across[1], across[2]);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec3<double> normal = across / length;
  // The fundamental forms; mean and Gaussian curvature are half the sum and the product.
  const double e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
  const double l = dot(suu, normal), m = dot(suv, normal), n = dot(svv, normal);
  const double det = length * length;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * det);
  const double gauss = (l * n - m * m) / det;
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  const double larger = mean < 0 ? mean - root : mean + root;
  if (!std::isfinite(larger)) return std::nullopt;
  return Curvature{{larger, larger == 0 ? 0 : gauss / larger}};
}

}  // namespace ccdfuzz
