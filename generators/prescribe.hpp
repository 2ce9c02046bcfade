#pragma once

#include "case/taxonomy.hpp"
#include "generators/draw/draw.hpp"
#include "generators/scene.hpp"

namespace ccdfuzz {

/// Which part of its patch a contact lies on: the interior, a boundary edge or a corner.
enum class Feature : std::uint8_t { kFace, kEdge, kCorner };

/// The features of patch 1 and patch 2 (Section 5.3: the lower-dimensional one comes first).
std::array<Feature, 2> features_of(ContactClass contact);
/// The class of contacts of such features, in either order.
ContactClass class_between(Feature a, Feature b);

/// Step I as the paper has it (Appendix E.2): a permutation of (1/2, 1/4, 1/4) in the interior, the
/// midpoint of an edge, or a corner.
Barycentric prescribe_in_parent(Feature feature, Draw& draw);

}  // namespace ccdfuzz
