#pragma once

#include <array>
#include <cstdint>

#include "bezier/patch.hpp"

namespace ccdfuzz {

/// A part of a shape's parameter domain that `depth` midpoint splits make. In units of 2^-depth:
///   curve     [i, i+1]
///   tensor    [i, i+1] × [j, j+1]
///   triangle  corners (i,j), (i+1,j), (i,j+1), or if inverted (i+1,j+1), (i,j+1), (i+1,j)
/// so a cell is exact at any depth up to kMaxDepth, and its corners are exact doubles.
struct Cell {
  std::uint64_t i = 0;
  std::uint64_t j = 0;
  int depth = 0;
  bool inverted = false;

  static constexpr int kMaxDepth = 50;

  /// Child c of a midpoint split, 0 ≤ c < shape.child_count(). Bit 0 of c is the upper half in u,
  /// bit 1 that in v. A triangle has its children at the corners (w, u, v), then the middle one,
  /// whose corners are the midpoints of (u, v), (w, v) and (w, u).
  Cell child(const Shape& shape, int c) const;

  /// The sub-domain's corners as (u, v); the rest is 0. A curve has 2. A triangle has 3 in the
  /// order (w, u, v) = origin, end of the local u axis, end of the local v axis. A tensor has 2,
  /// the lowest and the highest.
  std::array<Uv<double>, 3> corners(const Shape& shape) const;

  /// The midpoint (centroid of a triangle, rounded).
  Uv<double> centre(const Shape& shape) const;

  friend bool operator==(const Cell&, const Cell&) = default;
};

/// 24 well mixed bits.
inline size_t hash_of(const Cell& cell) {
  std::uint64_t h = cell.i * 0x9e3779b97f4a7c15 ^ cell.j * 0xc2b2ae3d27d4eb4f;
  h += static_cast<std::uint64_t>(cell.depth) * 2 + (cell.inverted ? 1 : 0);
  h ^= h >> 32;
  return h * 0x9e3779b97f4a7c15 >> 40;
}

}  // namespace ccdfuzz
