#include "generators/paper.hpp"

#include "generators/differential.hpp"
#include "generators/shaped/features.hpp"
#include "generators/tangent_cone.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

using Matrix2 = Eigen::Matrix<Dyadic, 2, 2>;
using Vector2 = Eigen::Matrix<Dyadic, 2, 1>;

/// A face as a graph over the contact plane, to second order. The plane is projected along the
/// coordinate in which its normal is largest, which is one-to-one.
/// At tangential offset δ, the height times normal² is δᵀ·form·δ / scale, scale > 0.
struct Graph {
  Matrix2 form;
  Dyadic scale;  ///< 0 if the face is degenerate
};

struct Projection {
  Vec3<Dyadic> normal;
  int dropped;  ///< coordinate

  explicit Projection(const Vec3<Dyadic>& n) : normal(n), dropped(largest_component(n)) {}
  Vector2 operator()(const Vec3<Dyadic>& p) const {
    return {p[(dropped + 1) % 3], p[(dropped + 2) % 3]};
  }
};

Graph graph_of(const Points<Dyadic>& points, const Barycentric& x, const Projection& project) {
  const std::array<Barycentric, 2> direction = {towards(corner_point(2), corner_point(0)),
                                                towards(corner_point(2), corner_point(1))};
  Matrix2 tangents, heights;
  for (int i = 0; i < 2; ++i) {
    tangents.col(i) = project(slope(points, x, direction[i]));
    for (int j = 0; j < 2; ++j) {
      heights(i, j) = dot(project.normal, bend(points, direction[i], direction[j]));
    }
  }
  // δ = tangents·(du, dv), so (du, dv) = adjugate·δ / det.
  Matrix2 adjugate;
  adjugate << tangents(1, 1), -tangents(0, 1), -tangents(1, 0), tangents(0, 0);
  const Dyadic det = tangents(0, 0) * tangents(1, 1) - tangents(0, 1) * tangents(1, 0);
  return {adjugate.transpose() * heights * adjugate, det * det};
}

std::optional<Vec3<Dyadic>> check_faces(const std::array<Points<Dyadic>, 2>& points,
                                        const std::array<Barycentric, 2>& x) {
  const TangentCone cone = tangent_cone(points[0], x[0]);
  const Vec3<Dyadic> normal = cross(cone.lines[0], cone.lines[1]);
  const Projection project(normal);
  const Graph one = graph_of(points[0], x[0], project), two = graph_of(points[1], x[1], project);
  if (one.scale.sign() == 0 || two.scale.sign() == 0) return std::nullopt;
  const Matrix2 gap = one.form * two.scale - two.form * one.scale;
  const Dyadic det = gap(0, 0) * gap(1, 1) - gap(0, 1) * gap(1, 0);
  if (det.sign() <= 0) return std::nullopt;
  return gap(0, 0).sign() > 0 ? normal : Vec3<Dyadic>(-normal);
}

std::optional<Vec3<Dyadic>> check_edge_on_face(const std::array<Points<Dyadic>, 2>& points,
                                               const std::array<Barycentric, 2>& x) {
  const TangentCone edge = tangent_cone(points[0], x[0]);
  auto normal = separating_normal(edge, tangent_cone(points[1], x[1]));
  if (!normal) return std::nullopt;
  const Projection project(*normal);
  const Graph face = graph_of(points[1], x[1], project);
  if (face.scale.sign() == 0) return std::nullopt;
  const int k = corner_opposite(x[0]);
  const Barycentric along = towards(corner_point((k + 1) % 3), corner_point((k + 2) % 3));
  const Vector2 tangent = project(edge.lines[0]);
  const Dyadic edge_height = dot(*normal, bend(points[0], along, along));
  const Vector2 curved = face.form * tangent;
  const Dyadic face_height = tangent[0] * curved[0] + tangent[1] * curved[1];
  if (edge_height * face.scale <= face_height) return std::nullopt;
  return normal;
}

}  // namespace

std::optional<Vec3<Dyadic>> static_check(const std::array<Points<Dyadic>, 2>& points,
                                         const std::array<Barycentric, 2>& x) {
  if (feature_at(x[1]) == Feature::kFace) {
    if (feature_at(x[0]) == Feature::kFace) return check_faces(points, x);
    if (feature_at(x[0]) == Feature::kEdge) return check_edge_on_face(points, x);
  }
  return separating_normal(tangent_cone(points[0], x[0]), tangent_cone(points[1], x[1]));
}

}  // namespace ccdfuzz
