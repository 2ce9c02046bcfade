#include "case/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/double_parts.hpp"
#include "numeric/exact_scalars.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

std::optional<InputError> fault_of_faces(const MovingPatch<double>& patch) {
  if (patch.faces.empty()) {
    if (!patch.one_sided) return std::nullopt;
    return InputError{"sides", "1 is of a mesh, and there are no faces"};
  }
  if (patch.shape.kind != ShapeKind::kHull) return InputError{"faces", "are of a hull alone"};
  if (patch.faces.size() > kMaxFaces) {
    return InputError{
        "faces", fmt::format("has {} triangles; a mesh has 1..{}", patch.faces.size(), kMaxFaces)};
  }
  const auto count = static_cast<int>(patch.positions.size());
  for (size_t f = 0; f < patch.faces.size(); ++f) {
    const Face& face = patch.faces[f];
    for (size_t i = 0; i < face.size(); ++i) {
      const auto fault = [&](const std::string& why) {
        return InputError{fmt::format("faces[{}][{}]", f, i), fmt::format("{} {}", face[i], why)};
      };
      if (face[i] < 0 || count <= face[i]) return fault(fmt::format("is outside 0..{}", count - 1));
      if (std::find(face.begin(), face.begin() + i, face[i]) != face.begin() + i) {
        return fault("is in the face twice");
      }
    }
  }
  if (compare(patch.radius, 0) == 0) return std::nullopt;
  return InputError{"radius", fmt::format("{} is not 0, as a mesh needs", patch.radius)};
}

std::optional<InputError> fault_of_pair(const std::array<MovingPatch<double>, 2>& patches) {
  for (const size_t side : {size_t{0}, size_t{1}}) {
    const MovingPatch<double>&patch = patches[side], &other = patches[1 - side];
    const auto fault = [&](std::string_view field, std::string what) {
      return InputError{fmt::format("patches[{}].{}", side, field), std::move(what)};
    };
    const bool is_hull = patch.shape.kind == ShapeKind::kHull;
    if (is_hull && other.shape.kind != ShapeKind::kHull) {
      return fault("shape", fmt::format("hull stands beside a {}; both patches are hulls, or none",
                                        name_of(other.shape.kind)));
    }
    if (side == 1 && !patch.faces.empty() && !other.faces.empty()) {
      return fault("faces", "stand beside patches[0].faces; one body of two may have them");
    }
    if (patch.turn && !(patch.faces.empty() && other.faces.empty())) {
      return fault(patch.turn->is_spin() ? "spin" : "turn",
                   fmt::format("stands beside patches[{}].faces; neither a mesh nor the other "
                               "body may have one",
                               patch.faces.empty() ? 1 - side : side));
    }
  }
  return std::nullopt;
}

bool has_mesh(const Query& query) {
  return !query.patches[0].faces.empty() || !query.patches[1].faces.empty();
}

std::vector<size_t> faces_there(const Query& query) {
  const size_t side = mesh_side(query);
  const MovingPatch<double>&mesh = query.patches[side], &other = query.patches[1 - side];
  const Vec3<Dyadic> way = exact_dyadic(other.velocities[0]) - exact_dyadic(mesh.velocities[0]);
  std::vector<size_t> there;
  for (size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto corner = [&](size_t i) {
      return exact_dyadic(mesh.positions[static_cast<size_t>(mesh.faces[f][i])]);
    };
    const Vec3<Dyadic> a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
    const Dyadic height = dot(cross(ab, ac), way);
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
  const auto* clearance = clearance_of<MeshClearance>(truth);
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
