#include "case/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/double_parts.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

std::optional<std::string> fault_of_faces(const MovingPatch<double>& patch) {
  if (patch.faces.empty() && patch.one_sided) return "is 1, and there are no faces";
  if (patch.faces.empty()) return std::nullopt;
  if (patch.shape.kind != ShapeKind::kHull) return "are of a hull alone";
  if (patch.faces.size() > kMaxFaces) {
    return fmt::format("has {} triangles; a mesh has 1..{}", patch.faces.size(), kMaxFaces);
  }
  const auto count = static_cast<int>(patch.positions.size());
  for (size_t f = 0; f < patch.faces.size(); ++f) {
    const auto [a, b, c] = patch.faces[f];
    for (const int corner : patch.faces[f]) {
      if (0 <= corner && corner < count) continue;
      return fmt::format("has the corner {} in [{}]; the points are 0..{}", corner, f, count - 1);
    }
    if (a == b || b == c || c == a) {
      return fmt::format("has the corner {} twice in [{}]", b == c ? b : a, f);
    }
  }
  if (compare(patch.radius, 0) != 0) {
    return fmt::format("are of a mesh, whose radius must be 0, not {}", patch.radius);
  }
  return std::nullopt;
}

std::optional<std::string> fault_of_mesh(const std::array<MovingPatch<double>, 2>& patches) {
  const auto& [a, b] = patches;
  if (!a.faces.empty() && !b.faces.empty()) return "has two meshes; one of them may have faces";
  if ((!a.faces.empty() || !b.faces.empty()) && (a.turn || b.turn)) {
    const size_t side = a.turn ? 0 : 1;
    return fmt::format("has a {} in [{}] beside a mesh, which is not supported",
                       patches[side].turn->is_spin() ? "spin" : "turn", side);
  }
  return std::nullopt;
}

bool has_mesh(const Query& query) {
  return !query.patches[0].faces.empty() || !query.patches[1].faces.empty();
}

std::vector<size_t> faces_there(const Query& query) {
  const size_t side = mesh_side(query);
  const MovingPatch<double>&mesh = query.patches[side], &other = query.patches[1 - side];
  const auto dyadic = [](const Vec3<double>& p) {
    return Vec3<Dyadic>(Dyadic::exact(p[0]), Dyadic::exact(p[1]), Dyadic::exact(p[2]));
  };
  const Vec3<Dyadic> way = dyadic(other.velocities[0]) - dyadic(mesh.velocities[0]);
  std::vector<size_t> there;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto corner = [&](size_t i) {
      return dyadic(mesh.positions[static_cast<size_t>(mesh.faces[f][i])]);
    };
    const Vec3<Dyadic> a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
    const Dyadic height = (ab[1] * ac[2] - ab[2] * ac[1]) * way[0] +
                          (ab[2] * ac[0] - ab[0] * ac[2]) * way[1] +
                          (ab[0] * ac[1] - ab[1] * ac[0]) * way[2];
    if (!mesh.one_sided || height.sign() < 0) there.push_back(f);
  }
  return there;
}

Query of_face(const Query& query, size_t face) {
  Query out = query;
  MovingPatch<double>& mesh = out.patches[mesh_side(query)];
  Points<double> corners;
  for (const int corner : mesh.faces[face]) {
    corners.push_back(mesh.positions[static_cast<size_t>(corner)]);
  }
  mesh.shape = Shape::hull(static_cast<int>(corners.size()));
  mesh.positions = std::move(corners);
  mesh.faces.clear();
  mesh.one_sided = false;
  return out;
}

void drop_point(MovingPatch<double>& body, size_t i) {
  const auto place = static_cast<int>(i);
  std::vector<Face> left;
  for (Face face : body.faces) {
    if (std::ranges::find(face, place) != face.end()) continue;
    for (int& corner : face) corner -= corner > place ? 1 : 0;
    left.push_back(face);
  }
  if (left.empty() != body.faces.empty()) return;
  body.faces = std::move(left);
  body.positions.erase(body.positions.begin() + place);
  body.shape = Shape::hull(static_cast<int>(body.positions.size()));
}

void drop_unused_points(MovingPatch<double>& mesh) {
  for (size_t i = mesh.positions.size(); i-- > 0;) {
    const bool is_used = std::ranges::any_of(mesh.faces, [&](const Face& face) {
      return std::ranges::find(face, static_cast<int>(i)) != face.end();
    });
    if (!is_used) drop_point(mesh, i);
  }
}

std::optional<TouchedFace> touched_face(const Case& value) {
  const Truth& truth = value.truth;
  const auto* clearance = truth.clearance ? std::get_if<MeshClearance>(&*truth.clearance) : nullptr;
  if (clearance == nullptr || truth.collides != true || !truth.witness) return std::nullopt;
  const size_t side = mesh_side(value.query);
  const std::vector<size_t> there = faces_there(value.query);
  for (size_t n = 0; n < there.size(); ++n) {
    const Face& face = value.query.patches[side].faces[there[n]];
    Rational sum = 0;
    for (const int corner : face) sum += truth.witness->weights[side][static_cast<size_t>(corner)];
    if (sum == 1) return TouchedFace{of_face(value.query, there[n]), nth_of(*clearance, n)};
  }
  return std::nullopt;
}

}  // namespace ccdfuzz
