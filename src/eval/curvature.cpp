#include "eval/curvature.hpp"

#include <cmath>

#include "certify/checker/polar.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

using ExactWeights = Weights<Rational>;

/// A surface at one point and time. A derivative is the blossom with a direction for each
/// differentiation, times n(n−1)….
class Differentiator {
 public:
  Differentiator(const MovingPatch<double>& patch, const Uv<Rational>& uv, const Rational& t)
      : shape_(patch.shape), net_(moving_net<Rational>(patch)), uv_(uv), t_(t) {}

  /// The derivative that many times by u and by v.
  Vec3<double> operator()(size_t in_u, size_t in_v) {
    int factor = 1;
    const auto arguments = [&](int degree, const ExactWeights& at,
                               std::vector<ExactWeights> directions) {
      for (int i = 0; i < std::ssize(directions); ++i) factor *= degree - i;
      directions.resize(static_cast<size_t>(degree), at);
      return directions;
    };
    const ExactWeights along_first = {-1, 1, 0}, along_second = {-1, 0, 1};
    std::vector<ExactWeights> first(in_u, along_first), second;
    if (shape_.kind == ShapeKind::kTriangle) {
      first.insert(first.end(), in_v, along_second);
      first = arguments(shape_.n, {Rational(1 - uv_[0] - uv_[1]), uv_[0], uv_[1]}, first);
    } else {
      first = arguments(shape_.n, {Rational(1 - uv_[0]), uv_[0], 0}, first);
      second.assign(in_v, along_first);
      second = arguments(shape_.m, {Rational(1 - uv_[1]), uv_[1], 0}, second);
    }
    const Moving<Rational>& p = polar_(shape_, net_, first, second);
    Vec3<double> out;
    for (size_t k = 0; k < 3; ++k) {
      out[static_cast<int>(k)] = Rational(factor * Rational(p[k] + t_ * p[k + 3])).get_d();
    }
    return out;
  }

 private:
  Shape shape_;
  MovingNet<Rational> net_;
  Uv<Rational> uv_;
  Rational t_;
  Polar<Rational> polar_;
};

}  // namespace

std::optional<double> rms_curvature(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                                    const Rational& t) {
  const ShapeKind kind = patch.shape.kind;
  const bool is_surface = kind == ShapeKind::kTriangle || kind == ShapeKind::kTensor;
  if (!is_surface || patch.is_rational()) return std::nullopt;
  Differentiator derivative(patch, uv, t);
  const Vec3<double> su = derivative(1, 0), sv = derivative(0, 1);
  const Vec3<double> across = cross(su, sv);
  const double length = std::hypot(across[0], across[1], across[2]);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec3<double> normal = across / length;
  // The fundamental forms; mean and Gaussian curvature are half the sum and the product.
  const double e = dot(su, su), f = dot(su, sv), g = dot(sv, sv);
  const double l = dot(derivative(2, 0), normal), m = dot(derivative(1, 1), normal),
               n = dot(derivative(0, 2), normal);
  const double det = length * length;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * det);
  const double gauss = (l * n - m * m) / det;
  // The principal curvatures are mean ± root.
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  const double rms = std::hypot(mean, root);
  return std::isfinite(rms) ? std::optional(rms) : std::nullopt;
}

}  // namespace ccdfuzz
