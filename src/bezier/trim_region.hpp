#pragma once

#include <cstdint>
#include <vector>

#include "bezier/cell.hpp"

namespace ccdfuzz {

/// Which part of its shape's domain a patch is over: the closed even-odd region of its loops.
/// Whatever the loops are, every answer is exact, in any floating-point environment.
class TrimRegion {
 public:
  enum class Cover : std::uint8_t { kInside, kCrossed, kOutside };

  /// The region of a trimmed patch; that of any other is whole. Keeps the memory.
  void assign(const MovingPatch<double>& patch);
  bool is_whole() const { return edges_.empty(); }

  /// kInside: all of the closed cell belongs to the region; kOutside: nothing of it does;
  /// kCrossed: an edge of a loop meets it. Between edges the parity does not change, so one vertex
  /// of a cell that no edge meets decides about all of it.
  Cover cover(const Cell& cell) const;

  /// The children of a crossed cell: bit c for child c. Those of a cell inside are inside.
  struct Children {
    unsigned outside = 0;
    unsigned crossed = 0;
  };
  Children children(const Cell& parent) const;

  bool contains(const Uv<double>& uv) const;

 private:
  struct Edge {
    Uv<double> from, to;
  };
  /// p is not on a loop.
  bool is_inside(const Uv<double>& p) const;

  Shape shape_;
  std::vector<Edge> edges_;
};

}  // namespace ccdfuzz
