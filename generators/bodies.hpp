#pragma once

#include "generators/attempts.hpp"

namespace ccdfuzz {

/// Whether bodies of these kinds are drawn in contacts of a class.
bool has_bodies(const BodyKinds& kinds, ContactClass contact);

/// One attempt at a case of two bodies (ShapeKind::kHull) with its truth, without its origin; or
/// why it was thrown away. They are points, segments, triangles, tetrahedra, boxes and hulls of up
/// to 15 points, with a radius or without. The class says what of each is in contact at t*: a
/// vertex, or a point inside of an edge or of a face. All numbers are floats (binary32) of few
/// bits, of sizes and speeds from 0.01 to 1000. One scene in eight is up to 2^16 away from the
/// origin; with options.binary64 it is up to 2^40 away, and its numbers are doubles. With
/// options.at_start one of RP in eight touches at t = 0, also of those that a mesh is made of. With
/// options.initial_overlap all do, or overlap: they start after their contact, by up to a unit of
/// time, and go on or back.
///
/// A frame has two directions in the contact plane and one out of it. If there is a radius, the
/// third direction has a rational length and is at right angles to the others. One body is on or
/// below the plane z = 0 of the frame, the other on or above z = (both radii). So the plane's
/// normal is certificate K up to t*, and the point on either plane is the witness. RP: t* < t_max.
/// RN: the same patches with t_max = t* − eps_t. NMN: moved away from each other, and moving along
/// the plane: they pass by at a distance that is proven.
///
/// With options.plane all is in the plane z = 0, and the frame's second direction out of it. In the
/// families that graze, the bodies move along the plane and stay on its two sides. Certificate K
/// has the plane's normal then, and does not hold; in the others it was not checked yet.
Attempted framed_bodies(const GeneratorOptions& options, Draw& draw);

/// A query of bodies as a case whose truth is decided, with the class of its contact. Where they
/// miss, it is the class of what is nearest. A contact at t = 0, or of bodies that turn, has none,
/// nor has a mesh that is missed.
/// nullopt if it is not decided.
std::optional<Case> case_of_bodies(const Query& query);

}  // namespace ccdfuzz
