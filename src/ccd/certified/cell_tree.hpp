#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "ccd/certified/kernels.hpp"
#include "ccd/certified/midpoint_program.hpp"

namespace ccdfuzz::certified {

/// The sub-patches of one moving patch, each made once by midpoint subdivision of its parent and
/// kept. A net stores each control point in kPerPoint places: position x, y, z, 0, velocity x, y,
/// z, 0.
class CellTree {
 public:
  using Node = std::uint32_t;

  /// Starts again with a patch's control points as node 0; keeps the memory.
  void reset(const Shape& shape, std::span<const std::array<double, 6>> controls);

  /// First of shape.child_count() consecutive children. A point is its own child.
  Node children(Node parent);

  const double* net(Node node) const { return &values_[size_t{node} * stride_]; }
  /// Which part of the domain a node is; walks up to the root.
  Cell cell(Node node) const;
  int depth(Node node) const { return nodes_[node].depth; }
  const Shape& shape() const { return shape_; }
  /// Control points of a net.
  int count() const { return static_cast<int>(stride_) / kPerPoint; }
  /// Roundings behind each control point of a node at this depth.
  int roundings(int depth) const { return program_->roundings * depth; }
  size_t bytes() const { return size_ * (stride_ * sizeof(double) + sizeof(Entry)); }

 private:
  static constexpr Node kNone = ~Node{0};

  struct Entry {
    Node parent = kNone;
    Node first_child = kNone;
    std::uint16_t depth = 0;
    std::uint16_t place = 0;  ///< which child of its parent
  };

  /// Makes room for `more` nodes, their nets not set.
  void grow(size_t more);

  Shape shape_;
  const MidpointProgram* program_ = nullptr;
  size_t stride_ = 0;
  size_t size_ = 0;             ///< nodes
  std::vector<double> values_;  ///< of all nodes and, unused, more
  std::vector<Entry> nodes_;    ///< likewise
  std::vector<double> slots_;
};

}  // namespace ccdfuzz::certified
