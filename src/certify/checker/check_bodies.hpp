#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

// Two bodies are in contact at t iff a point of one hull is no farther than
//   reach = separation + radius 1 + radius 2
// from a point of the other. All is checked in exact rationals, lengths by their squares.

/// Certificate W of bodies. Checks that the weights are ≥ 0 and sum to 1, and that t ≥ 0, which may
/// lie past t_max, and is at most 1 where a body turns. They make a point of each hull, or of one
/// face of a mesh that is there (case/mesh.hpp). These points may be no farther apart at t than the
/// reach. Requires a valid query. Errors: what is wrong, naming
/// the field; more than most_work.
///
/// Where a body turns, its point may be known but for an error, and the reach is less by that. But
/// each hull holds a ball about its point (radius_within), and so the reach is longer by both
/// radii. So hulls without a radius need a point inside of one of them. Bodies in the plane z = 0
/// stay there (is_in_plane), errors as well, so that a disc in it does for a ball.
Result<void> check_body_contact(const Query& query, const Witness& witness,
                                std::uint64_t most_work = kMostWork);

/// Certificate K: checks that the two bodies are farther apart than the reach at every t in [0,
/// until), or in the closed [0, until]. Requires a valid query. Errors: what is wrong, naming the
/// field; more than kMostWork.
///
/// Proof. Let g(t) = min normal·(points of patch 1) − max normal·(points of patch 2). The hulls are
/// no nearer than g/|normal|. Each body moves by one velocity, so g is linear in t. What holds
/// strictly at 0, and at `until` strictly or (half-open) not strictly, holds between them.
Result<void> check_body_clearance(const Query& query, const BodyClearance& clearance);

/// Certificate F: checks certificate K of each face of a mesh that is there (case/mesh.hpp), as the
/// hull of its corners. Requires a valid query of bodies. Errors: there are more normals than such
/// faces, or fewer; as of certificate K.
Result<void> check_mesh_clearance(const Query& query, const MeshClearance& clearance);

}  // namespace ccdfuzz
