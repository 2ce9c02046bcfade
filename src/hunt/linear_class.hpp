#pragma once

#include <array>
#include <optional>

#include "case/query.hpp"
#include "case/taxonomy.hpp"

namespace ccdfuzz {

/// The classes that linear queries come in, by their shapes: vertex-face, edge-edge, vertex-edge,
/// vertex-vertex.
inline constexpr std::array kLinearClasses = {ContactClass::kVF, ContactClass::kEE,
                                              ContactClass::kVE, ContactClass::kVV};

/// The class of a query by its shapes, in either order: points, and curves and triangles of degree
/// 1. None of others, which are not linear.
std::optional<ContactClass> linear_class_of(const Query& query);

}  // namespace ccdfuzz
