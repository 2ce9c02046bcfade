#pragma once

#include <tl/expected.hpp>

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {

/// One attempt at a case of a convex body and a mesh (case/mesh.hpp) without its origin; or why it
/// was thrown away. They touch as two bodies of bodies_case do, of which one gave its points to the
/// mesh. What is in contact is inside of a face, on an edge of two faces, or a corner of a fan.
/// More faces are put to edges that there are. Their third corners are those of others, across the
/// edge in the face's plane, far away along the edge, or anywhere. So there are strips, folded
/// sheets and long thin triangles, and some close a tetrahedron. In one mesh of four the body
/// nearly grazes a face before. All numbers are floats.
///
/// The oracle decides. Kept is what touches at t* first, or does not. One-sided, the faces that are
/// touched are fronts. In half of the cases RN, which end after t*, the body comes from behind.
///
/// Those of mesh-grazing touch as bodies of grazing_bodies_case do. A last face is across the way
/// of the body. Kept is what touches another face first, without depth, and then passes well
/// through the last. Whoever stops at the face that is touched first misses that. One-sided, all
/// faces are fronts that can be.
tl::expected<Case, Discard> mesh_case(const GeneratorOptions& options, const Dyadic& eps_t,
                                      Draw& draw);

}  // namespace ccdfuzz
