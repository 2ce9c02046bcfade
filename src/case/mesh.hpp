#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"

namespace ccdfuzz {

// A hull with faces is a mesh: the union of these triangles of its points, with the radius 0.
//
// If it is one-sided, not all of its faces are there. A face is iff n·v < 0, in exact arithmetic: n
// = (b − a) × (c − a) for its corners a, b, c, and v the other body's velocity less the mesh's. So
// what moves along a face or towards its back passes through it, and through a face without area.
// With two sides all faces are there. Absence of contact is that with each face that is.

inline constexpr size_t kMaxFaces = 8;

/// What is wrong with the faces of one patch, and in which of its fields. They are too many; a
/// corner is no point, or twice in a face; there is a radius, or no hull. nullopt: nothing, or no
/// faces.
std::optional<InputError> fault_of_faces(const MovingPatch<double>& patch);
/// What is wrong with two patches beside each other, in which field of a query: one hull alone; two
/// meshes; or a body that turns beside one.
std::optional<InputError> fault_of_pair(const std::array<MovingPatch<double>, 2>& patches);

/// One of its bodies is a mesh.
bool has_mesh(const Query& query);
/// Which one. Requires has_mesh.
inline size_t mesh_side(const Query& query) {
  return query.patches[0].faces.empty() ? 1 : 0;
}

/// The places of the faces that are there, ascending. Requires a valid query with a mesh.
std::vector<size_t> faces_there(const Query& query);
/// The query about one face, as the hull of its corners.
Query of_face(const Query& query, size_t face);

/// Takes point i away, and with it the faces that have it as a corner; nothing of a mesh that would
/// have no face left.
void drop_point(MovingPatch<double>& body, size_t i);
/// Takes the points away that are no corners.
void drop_unused_points(MovingPatch<double>& mesh);

/// The first face that is there and has the point of a mesh's witness. nullopt where
/// the truth has no witness, or no certificate F.
struct TouchedFace {
  Query query;              ///< about this face alone
  BodyClearance clearance;  ///< this face's
};
std::optional<TouchedFace> touched_face(const Case& value);

/// The direction of a mesh's certificate that belongs to the nth face that is there.
inline BodyClearance nth_of(const MeshClearance& clearance, size_t n) {
  return {clearance.until, clearance.normals[n], clearance.closed};
}

}  // namespace ccdfuzz
