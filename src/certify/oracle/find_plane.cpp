#include "certify/oracle/find_plane.hpp"

#include <algorithm>
#include <utility>
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
  const bool is_triangle = shape.kind == ShapeKind::kTriangle;
  const Weights<Rational> at = is_triangle
                                   ? Weights<Rational>{Rational(1 - uv[0] - uv[1]), uv[0], uv[1]}
                                   : Weights<Rational>{Rational(1 - uv[0]), uv[0], 0};
  std::vector<Weights<Rational>> u(static_cast<size_t>(shape.n), at),
      v(static_cast<size_t>(shape.m), {Rational(1 - uv[1]), uv[1], 0});
  const Moving<Rational> here = polar(shape, net, u, v);
  std::vector<Vector> out;
  const auto add = [&](Weights<Rational>& argument, const Weights<Rational>& direction) {
    const Weights<Rational> point_of_argument = std::exchange(argument, direction);
    const Moving<Rational> along = polar(shape, net, u, v);
    argument = point_of_argument;
    out.push_back(value_at(along, t));
    if (!patch.is_rational()) return;
    out.back() = out.back() * here[kWeight] - value_at(here, t) * along[kWeight];
  };
  if (shape.kind != ShapeKind::kPoint) add(u[0], {-1, 1, 0});
  if (shape.kind == ShapeKind::kTensor) add(v[0], {-1, 1, 0});
  if (is_triangle) add(u[0], {-1, 0, 1}), add(u[0], {0, 1, -1});
  return out;
}

}  // namespace

std::optional<MovingPlane> find_plane(const Query& query, const Witness& witness) {
  std::array<std::vector<Vector>, 2> tangent;
  std::array<Vector, 2> velocity, point;
  for (size_t s = 0; s < 2; ++s) {
    const MovingPatch<Rational> patch = exact_patch<Rational>(query.patches[s]);
    tangent[s] = tangents(query.patches[s], witness.uv[s], witness.t);
    velocity[s] = evaluate<Rational>(patch.shape, patch.velocities, patch.weights, witness.uv[s]);
    point[s] = evaluate<Rational>(patch, witness.uv[s], witness.t);
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
  normals.emplace_back(point[0] - point[1]);
  for (Vector& n : normals) {
    const Rational rate = dot(n, approach);
    if (rate == 0) continue;
    if (rate > 0) n = -n;  // patch 1, on the normal's side, comes from there
    const MovingPlane plane{witness.t, n, dot(n, point[1])};
    if (check_plane(query, plane)) return plane;
  }
  return std::nullopt;
}

std::optional<MovingPlane> find_plane_near(const Query& query, const MovingPlane& near,
                                           const Rational& until) {
  if (!is_readable(until)) return std::nullopt;
  MovingPlane plane{until, near.normal, near.offset};
  if (check_plane(query, plane)) return plane;
  std::vector<Vector> normals = {near.normal};
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {1, -1}) normals.emplace_back(0, 0, 0)[k] = sign;
  }
  const MovingPatch<Rational> behind = exact_patch<Rational>(query.patches[1]);
  for (const Vector& n : normals) {
    std::vector<Rational> heights;
    for (size_t i = 0; i < behind.positions.size(); ++i) {
      heights.push_back(dot(n, Vector(behind.positions[i] + behind.velocities[i] * until)));
    }
    plane.normal = n;
    plane.offset = *std::max_element(heights.begin(), heights.end());
    if (is_readable(plane.offset) && check_plane(query, plane)) return plane;
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
