#pragma once

#include <array>
#include <string>

#include "base/result.hpp"
#include "bezier/shape.hpp"

namespace ccdfuzz {

/// Reads one shape for both patches, or one for each with a comma between: "point", "curve:N",
/// "triangle:N", "tensor:NxM", degrees 1 to kMaxDegree. Errors: anything else, naming `where`.
Result<std::array<Shape, 2>> parse_shapes(const std::string& where, const std::string& text);

}  // namespace ccdfuzz
