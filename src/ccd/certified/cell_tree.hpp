#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "ccd/certified/midpoint_program.hpp"

namespace ccdfuzz::certified {

/// The sub-patches of one moving patch, each made once by midpoint subdivision of its parent and
/// kept. A net stores its components apart (x of all positions, y, z, then those of the
/// velocities), each padded to a multiple of 4 by repeating the last control point, so that loops
/// need no remainder.
class CellTree {
 public:
  using Node = std::uint32_t;

  /// Starts again with a patch's control points as node 0; keeps the memory.
  void reset(const Shape& shape, std::span<const std::array<double, 6>> controls);

  /// First of shape.child_count() consecutive children. A point is its own child.
  Node children(Node parent);

  const double* net(Node node) const { return &values_[size_t{node} * stride_]; }
  const Cell& cell(Node node) const { return cells_[node]; }
  const Shape& shape() const { return shape_; }
  int width() const { return width_; }  ///< padded control count
  /// Roundings behind each control point of a node at this depth.
  int roundings(int depth) const { return program_->roundings * depth; }
  size_t bytes() const {
    return values_.size() * sizeof(double) + cells_.size() * (sizeof(Cell) + sizeof(Node));
  }

 private:
  static constexpr Node kNone = ~Node{0};

  void store(Node node, std::span<const std::array<double, 6>> slots,
             const std::vector<int>& places);

  Shape shape_;
  const MidpointProgram* program_ = nullptr;
  int width_ = 0;
  size_t stride_ = 0;
  std::vector<double> values_;
  std::vector<Cell> cells_;
  std::vector<Node> first_child_;
  std::vector<std::array<double, 6>> slots_;
};

}  // namespace ccdfuzz::certified
