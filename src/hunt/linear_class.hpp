#pragma once

#include <array>
#include <optional>

#include "bezier/shape.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

/// The classes that linear queries come in, by their shapes: vertex-face, edge-edge, vertex-edge,
/// vertex-vertex.
inline constexpr std::array kLinearClasses = {ContactClass::kVF, ContactClass::kEE,
                                              ContactClass::kVE, ContactClass::kVV};

/// The class of a linear query with these shapes, in either order: points, curves and triangles of
/// degree 1. None of others.
std::optional<ContactClass> linear_class_of(const std::array<Shape, 2>& shapes);

}  // namespace ccdfuzz
