#pragma once

#include <array>
#include <optional>

#include "bezier/shape.hpp"
#include "case/query.hpp"
#include "case/scale.hpp"
#include "case/taxonomy.hpp"
#include "finds/failure.hpp"

namespace ccdfuzz {

/// The classes that linear queries come in, by their shapes: vertex-face, edge-edge, vertex-edge,
/// vertex-vertex.
inline constexpr std::array kLinearClasses = {ContactClass::kVF, ContactClass::kEE,
                                              ContactClass::kVE, ContactClass::kVV};

/// The class of a query by its shapes, in either order: points, and curves and triangles of degree
/// 1. None of others, which are not linear.
std::optional<ContactClass> linear_class_of(const Query& query);

/// Which queries a hunt is about; by default all.
struct HuntGround {
  /// Within this scale (is_within_scale), in bits.
  std::optional<int> scale;
  /// The shapes of patches 1 and 2.
  std::optional<std::array<Shape, 2>> shapes;
  /// Linear queries, of kLinearClasses alone, and not curved ones. Then shapes are not set.
  bool linear = false;
  /// Queries of bodies, and not of patches. Then neither shapes nor linear is set.
  bool bodies = false;
  /// Only queries all of whose numbers are floats.
  bool binary32 = false;
  /// Only cases of Setting::kOrdinary.
  bool ordinary = false;

  /// Whether a query is of that scale, of those shapes, and linear if so.
  bool has(const Query& query) const {
    const auto is_of_shape = [&](std::size_t s) { return query.patches[s].shape == (*shapes)[s]; };
    return (!scale || is_within_scale(query, *scale)) &&
           (!shapes || (is_of_shape(0) && is_of_shape(1))) && (!linear || linear_class_of(query)) &&
           (!bodies || is_of_bodies(query)) && (!binary32 || is_binary32(query));
  }

  /// The same of a case, which is ordinary if only those count.
  bool has(const Case& value) const {
    return has(value.query) && (!ordinary || setting_of(value) == Setting::kOrdinary);
  }
};

}  // namespace ccdfuzz
