#pragma once

#include <optional>

#include "base/result.hpp"
#include "bezier/patch.hpp"

namespace ccdfuzz {

/// Vertices of all loops of a patch. All pairs of edges are compared: 131,000, which take less than
/// a second even where every comparison needs numbers of 2,000 bits.
inline constexpr size_t kMaxTrimVertices = 512;

/// 1 inside of the loop, 0 on it, −1 outside. Exact.
int place_of(const Uv<double>& p, const std::vector<Uv<double>>& loop);

/// What is wrong with the loops of a patch of this shape, at "trim", "trim[loop]" or
/// "trim[loop][vertex]"; nullopt if nothing is. These are the laws: The shape is a triangle or a
/// tensor. All loops together have kMaxTrimVertices vertices at most. Each loop has an area, and
/// three vertices or more, which are finite and in the domain. Two edges of a loop share no point,
/// apart from the vertex where one ends and the next begins. No edge crosses an edge of another
/// loop. No loop has vertices both strictly inside and strictly outside of another. So loops may
/// touch in points and along edges, and lie inside of another.
std::optional<InputError> fault_of(const Trim& trim, const Shape& shape);

}  // namespace ccdfuzz
