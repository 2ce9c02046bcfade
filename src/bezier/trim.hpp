#pragma once

#include <optional>
#include <string>

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// Vertices of all loops of a patch. All pairs of edges are compared: 131,000, which take less than
/// a second even where every comparison needs numbers of 2,000 bits.
inline constexpr size_t kMaxTrimVertices = 512;

/// What is wrong with a loop, or one of its vertices, or with all loops.
struct TrimFault {
  std::optional<size_t> loop, vertex;
  std::string what;
};

/// What is wrong with the loops of a patch of this shape.
/// nullopt if nothing is:
///   the shape is a triangle or a tensor, and has kMaxTrimVertices vertices at most;
///   each loop has three vertices or more, all finite and in the domain, and an area;
///   a loop shares no point with itself, apart from those where an edge ends and the next begins;
///   no edge crosses an edge of another loop, and no loop has vertices strictly inside of another
///   and strictly outside. So loops may touch in points and along edges, and be inside of another.
std::optional<TrimFault> fault_of(const Trim& trim, const Shape& shape);

}  // namespace ccdfuzz
