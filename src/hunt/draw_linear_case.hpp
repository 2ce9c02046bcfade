#pragma once

#include <array>

#include "query/case.hpp"
#include "query/taxonomy.hpp"

namespace ccdfuzz {

/// The classes that linear queries come in, by their shapes: vertex-face, edge-edge, vertex-edge,
/// vertex-vertex.
inline constexpr std::array kLinearClasses = {ContactClass::kVF, ContactClass::kEE,
                                              ContactClass::kVE, ContactClass::kVV};

/// Linear case number `index` of such a class: degenerate in any of the ways that linear codes fail
/// on (draw_linear), with a truth that exact arithmetic decides and the checker accepts. Depends on
/// the arguments alone.
Case draw_linear_case(ContactClass contact, std::uint64_t seed, std::uint64_t index);

}  // namespace ccdfuzz
