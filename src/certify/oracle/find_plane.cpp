#include "certify/oracle/find_plane.hpp"

#include <vector>

#include "bezier/blossom.hpp"
#include "bezier/exact_patch.hpp"
#include "certify/checker/check_plane.hpp"
#include "certify/checker/polar.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

using Vector = Vec3<Rational>;

Vector value_at(const Moving<Rational>& p, const Rational& t) {
  return {Rational(p[0] + t * p[3]), Rational(p[1] + t * p[4]), Rational(p[2] + t * p[5])};
}

/// The derivatives of a patch at a point along its parameters and, for a triangle, along u − v.
/// Those of N/w are (N'·w − N·w')/w², of which the numerator has the direction.
std::vector<Vector> tangents(const MovingPatch<double>& patch, const Uv<Rational>& uv,
                             const Rational& t) {
  const Shape& shape = patch.shape;
  const MovingNet<Rational> net = moving_net<Rational>(patch);
  Polar<Rational> polar(nullptr, patch.is_rational());
  std::vector<Vector> out;
  const auto value = [&](const Weights<Rational>* first, const Weights<Rational>* second) {
    const bool triangle = shape.kind == ShapeKind::kTriangle;
    const Weights<Rational> at = triangle
                                     ? Weights<Rational>{Rational(1 - uv[0] - uv[1]), uv[0], uv[1]}
                                     : Weights<Rational>{Rational(1 - uv[0]), uv[0], 0};
    std::vector<Weights<Rational>> u(static_cast<size_t>(shape.n), at),
        v(static_cast<size_t>(shape.m), {Rational(1 - uv[1]), uv[1], 0});
    if (first != nullptr) u[0] = *first;
    if (second != nullptr) v[0] = *second;
    return polar(shape, net, u, v);
  };
  const Moving<Rational> here = value(nullptr, nullptr);
  const auto add = [&](const Weights<Rational>* first, const Weights<Rational>* second) {
    const Moving<Rational> along = value(first, second);
    out.push_back(value_at(along, t));
    if (!patch.is_rational()) return;
    const Vector point = value_at(here, t);
    for (int k = 0; k < 3; ++k) {
      out.back()[k] = out.back()[k] * here[kWeight] - point[k] * along[kWeight];
    }
  };
  const Weights<Rational> along = {-1, 1, 0}, along_v = {-1, 0, 1}, across = {0, 1, -1};
  if (shape.kind != ShapeKind::kPoint) add(&along, nullptr);
  if (shape.kind == ShapeKind::kTensor) add(nullptr, &along);
  if (shape.kind == ShapeKind::kTriangle) add(&along_v, nullptr), add(&across, nullptr);
  return out;
}

}  // namespace

std::optional<MovingPlane> find_plane(const Query& query, const Witness& witness) {
  std::array<std::vector<Vector>, 2> tangent;
  std::array<Vector, 2> velocity;
  Vector contact;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Rational> patch = exact_patch<Rational>(query.patches[s]);
    tangent[s] = tangents(query.patches[s], witness.uv[s], witness.t);
    velocity[s] = evaluate<Rational>(patch.shape, patch.velocities, patch.weights, witness.uv[s]);
    if (s == 0) contact = evaluate<Rational>(patch, witness.uv[s], witness.t);
  }
  const Vector approach = velocity[0] - velocity[1];
  std::vector<Vector> normals;
  for (const std::vector<Vector>& t : tangent) {
    if (t.size() >= 2) normals.push_back(cross(t[0], t[1]));
  }
  for (const Vector& a : tangent[0]) {
    for (const Vector& b : tangent[1]) normals.push_back(cross(a, b));
  }
  normals.push_back(approach);
  for (Vector& n : normals) {
    const Rational rate = dot(n, approach);
    if (rate == 0) continue;
    if (rate > 0) n = -n;  // patch 1, on the normal's side, comes from there
    const MovingPlane plane{witness.t, {n[0], n[1], n[2]}, dot(n, contact)};
    if (check_plane(query, plane)) return plane;
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
