#include "report/tessellate.hpp"

#include <Eigen/Geometry>

#include "bezier/blossom.hpp"

namespace ccdfuzz {

Tessellation tessellate(const Shape& shape, int steps) {
  Tessellation mesh;
  const auto part = [&](int i) { return static_cast<double>(i) / steps; };
  if (shape.parameter_count() < 2) {
    const int last = shape.kind == ShapeKind::kCurve ? steps : 0;
    for (int i = 0; i <= last; ++i) mesh.at.push_back({part(i), 0});
    return mesh;
  }
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  std::vector<std::uint32_t> rows;
  for (int i = 0; i <= steps; ++i) {
    rows.push_back(static_cast<std::uint32_t>(mesh.at.size()));
    for (int j = 0; j <= (triangle ? steps - i : steps); ++j) mesh.at.push_back({part(i), part(j)});
  }
  for (int i = 0; i < steps; ++i) {
    const int last = triangle ? steps - i : steps;
    for (int j = 0; j < last; ++j) {
      const std::uint32_t a = rows[static_cast<size_t>(i)] + static_cast<std::uint32_t>(j);
      const std::uint32_t b = rows[static_cast<size_t>(i) + 1] + static_cast<std::uint32_t>(j);
      mesh.triangles.push_back({a, b, a + 1});
      if (!triangle || j + 1 < last) mesh.triangles.push_back({b, b + 1, a + 1});
    }
  }
  return mesh;
}

std::vector<std::array<std::uint32_t, 2>> net_lines(const Shape& shape) {
  const bool triangle = shape.kind == ShapeKind::kTriangle;
  const auto inside = [&](int i, int j) {
    return i >= 0 && j >= 0 && (triangle ? i + j <= shape.n : i <= shape.n && j <= shape.m);
  };
  const auto place = [&](int i, int j) { return static_cast<std::uint32_t>(shape.index(i, j)); };
  std::vector<std::array<std::uint32_t, 2>> lines;
  for (int i = 0; i <= shape.n; ++i) {
    for (int j = 0; inside(i, j); ++j) {
      if (inside(i + 1, j)) lines.push_back({place(i, j), place(i + 1, j)});
      if (inside(i, j + 1)) lines.push_back({place(i, j), place(i, j + 1)});
      if (triangle && inside(i + 1, j - 1)) lines.push_back({place(i, j), place(i + 1, j - 1)});
    }
  }
  return lines;
}

Points<double> vertices_at(const MovingPatch<double>& patch, const Tessellation& mesh, double t) {
  const Points<double> controls = patch.at(t);
  Points<double> vertices;
  vertices.reserve(mesh.at.size());
  for (const Uv<double>& uv : mesh.at) {
    vertices.push_back(evaluate<double>(patch.shape, controls, uv));
  }
  return vertices;
}

Points<double> normals_of(const Tessellation& mesh, const Points<double>& vertices) {
  Points<double> normals(vertices.size(), Vec3<double>(0, 0, 0));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3<double> normal = (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]);
    for (const std::uint32_t v : {a, b, c}) normals[v] += normal;
  }
  for (Vec3<double>& normal : normals) {
    normal = normal.norm() > 0 ? Vec3<double>(normal.normalized()) : Vec3<double>(0, 0, 1);
  }
  return normals;
}

}  // namespace ccdfuzz
