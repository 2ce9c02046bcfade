#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bezier/trim_region.hpp"
#include "ccd/certified/kernels.hpp"
#include "ccd/certified/midpoint_program.hpp"
#include "numeric/block_array.hpp"

namespace ccdfuzz::certified {

/// The sub-patches of one moving patch, each made once by midpoint subdivision of its parent and
/// kept. Children cover their parent, and a net's hull holds its cell: so Laws A, B and C lose no
/// contact of the patch. A net stores each control point in kPerPoint places: position x, y, z, 0,
/// velocity x, y, z, 0; of a rational patch all times its weight w, and w in place of the first 0.
class CellTree {
 public:
  using Node = std::uint32_t;

  /// Starts again with a patch's control points as node 0; keeps the memory. weights: one for each,
  /// or none.
  void reset(const Shape& shape, std::span<const std::array<double, 6>> controls,
             std::span<const double> weights = {});

  /// Takes the loops of a patch, for outside(). Call it before reset, which gets the same patch.
  void trim(const MovingPatch<double>& patch) { region_.assign(patch); }
  /// Bit c for child c that is outside of the loops' region. Requires that children(parent) was
  /// called.
  unsigned outside(Node parent) const { return nodes_[parent]->outside; }

  /// First of shape.child_count() consecutive children. A point is its own child.
  Node children(Node parent);

  const double* net(Node node) const { return values_[node]; }
  /// Which part of the domain a node is; walks up to the root.
  Cell cell(Node node) const;
  int depth(Node node) const { return nodes_[node]->depth; }
  const Shape& shape() const { return shape_; }
  /// Control points of a net.
  int count() const { return static_cast<int>(stride_) / kPerPoint; }
  /// Roundings behind each control point of a node at this depth: Law C counts them, and beside
  /// them NormalisedQuery::roundings. A rational patch has those of numerator and weight, of the
  /// first product and of the quotient.
  int roundings(int depth) const {
    const int averages = program_->roundings * depth;
    return is_rational_ ? 2 * averages + 2 : averages;
  }
  /// Bytes of all nodes, and of the memory that is held for them.
  size_t bytes() const { return made_ * (stride_ * sizeof(double) + sizeof(Entry)); }
  size_t held() const { return values_.held() + nodes_.held(); }
  /// Without nodes, until the next reset; keeps the memory.
  void clear() {
    values_.reset(stride_);
    nodes_.reset();
  }
  /// Gives back what is held beyond so many bytes, but for the nodes.
  void keep_at_most(size_t bytes) {
    values_.keep_at_most(bytes / 2);
    nodes_.keep_at_most(bytes / 2);
  }

 private:
  static constexpr Node kNone = ~Node{0};

  struct Entry {
    Node parent = kNone;
    Node first_child = kNone;
    std::uint8_t depth = 0;
    std::uint8_t place = 0;    ///< which child of its parent
    std::uint8_t outside = 0;  ///< bit c for child c that is outside of the trim
    bool crossed = false;      ///< a loop of the trim meets it
  };

  Shape shape_;
  TrimRegion region_;
  bool is_rational_ = false;
  const MidpointProgram* program_ = nullptr;
  size_t stride_ = 1;
  size_t made_ = 0;            ///< nodes
  BlockArray<double> values_;  ///< nets of all nodes
  BlockArray<Entry> nodes_;    ///< likewise
  std::vector<double> slots_;
};

}  // namespace ccdfuzz::certified
