#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/verify.hpp"
#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/pair_axes.hpp"
#include "ccd/certified/tiers.hpp"
#include "ccd/certified/window_trim.hpp"
#include "ccd/exclusion.hpp"

namespace ccdfuzz::certified {

/// A pair of cells, and the window in which they may touch.
struct CellPair {
  Window window{};
  Axis hint{};  ///< the last of the pair's own axes that shortened its window, or its parent's hint
  std::array<CellTree::Node, 2> cells{};
  /// How often each was split. The two may differ. A point is split, too, and stays the same node.
  std::array<std::uint8_t, 2> depths{};

  int least_depth() const { return std::min(depths[0], depths[1]); }
};

/// The inclusion test of tdibm-c (DERIVATION.md, 0). It splits a pair of cells. For each pair of
/// their children it finds the part of the window in which no axis certifies them apart.
/// Guarantee: a time at which two children touch is never taken from their window, nor the pair
/// dropped. Laws A, B and C say what an axis takes from a window. Any vector is an axis. Requires
/// FpGuard::holds(). One object serves one thread and keeps its buffers between queries.
class PairSplit {
 public:
  using Node = CellTree::Node;

  /// All pairs of children share the axes before this one: 0..2 are the coordinate axes, 3 is the
  /// parent's hint, 4 and 5 are the parents' normals. From it on come those of CandidateAxes.
  static constexpr int kFirstOwnAxis = 6;

  static constexpr int kMostPairs = 16;
  /// All children of both cells.
  static constexpr std::array<unsigned, 2> kAll = {15, 15};

  /// Normalises a query: all that its fast path needs.
  void take(const Query& query) {
    normalise(query, query_);
    for (size_t s = 0; s < 2; ++s) trees_[s].trim(query.patches[s]);
  }
  /// Makes the whole patches of the query taken last, before the first split.
  /// finest: the depth to which pairs will be split. Pairs of coarser depth skip all but the first
  /// batch of CandidateAxes if nothing has shortened their window by then. This may add splits; it
  /// drops nothing.
  void begin(int finest);

  const NormalisedQuery& query() const { return query_; }
  const CellTree& tree(int side) const { return trees_[side]; }
  /// What decided. Those of linear queries are for the caller to count.
  Tiers& tiers() { return tiers_; }
  const Tiers& tiers() const { return tiers_; }
  /// Bytes of all cells, and of the memory that is held for them.
  size_t bytes() const { return trees_[0].bytes() + trees_[1].bytes(); }
  size_t held() const { return trees_[0].held() + trees_[1].held(); }
  void clear() {
    for (CellTree& tree : trees_) tree.clear();
  }
  void keep_at_most(size_t bytes) {
    for (CellTree& tree : trees_) tree.keep_at_most(bytes / 2);
  }

  /// Splits both cells of a pair, or the coarser one if their depths differ. Writes the pairs of
  /// children that may touch to `kept`, in the order of their places, and returns how many.
  /// wanted: of each cell, bit c for child c; a cell that is not split is its own child 0. Children
  /// outside of their patch's trim are not kept.
  int split(const CellPair& pair, const std::array<unsigned, 2>& wanted,
            std::span<CellPair, kMostPairs> kept, ExclusionObserver* observer = nullptr);

 private:
  /// The control points of a snapshot.
  using SnapshotValues = std::array<double, kPerPoint * kMaxControls>;

  /// The children of a cell, at the ends of the pair's window.
  struct Children {
    Node first;
    unsigned wanted;  ///< bit c for child c
    alignas(32) SnapshotValues values[4];
  };
  /// Three axes that all pairs of children share, and the extents of the children on them.
  struct SharedAxes {
    int first;       ///< number of the first axis
    AxisBatch axes;  ///< the last lane is none
    Bounds bounds;
    RangeBatch extents[2][4];  ///< of the children that are looked at
  };

  Node node(int side, int child) const { return children_[side].first + static_cast<Node>(child); }
  /// Counts the roundings of Law C anew, to check CellTree::roundings where assertions are on.
  Provenance provenance(int side, Node cell, const Window& window) const {
    const Shape& shape = query_.shapes[static_cast<size_t>(side)];
    const int averages = (shape.n + shape.m) * trees_[side].depth(cell);
    return {window,
            query_.weights[static_cast<size_t>(side)].empty() ? averages : 2 * averages + 2};
  }
  Snapshot snapshot(int side, int child) const {
    return {children_[side].values[child].data(), trees_[side].count(),
            provenance(side, node(side, child), window_)};
  }

  void prepare(const CellPair& pair, const std::array<unsigned, 2>& wanted);
  /// Drops pairs by Laws A and C.
  unsigned test(const SharedAxes& shared, unsigned pairs, ExclusionObserver* observer) const;
  /// Shortens w by Law B. Returns lo > hi where nothing is left.
  Window trim(const SharedAxes& shared, int a, int b, ExclusionObserver* observer, Window w);
  /// Counts a window of which several axes together exclude all (Laws A and B). Returns false.
  bool drop_together([[maybe_unused]] const Window& left) {
    CCDFUZZ_ASSERT(left.lo > left.hi);
    ++tiers_.together;
    return false;
  }
  /// Drops the pair by Laws A and C, or shortens its window by Law B, then by Laws A and C
  /// (Newton).
  bool narrow(int a, int b, ExclusionObserver* observer, CellPair& kept);

  /// Deeper down windows are so short that h is almost a line, whose root the chord finds.
  static constexpr int kNewtonLevels = 3;
  /// From this depth on, pairs that are to be a distance apart take their axes at the window's
  /// start, where a hit would be. Halfway, patches that turn have other normals, which leave many
  /// pairs of a level together. Pops are fewest with 3, of the depths 0, 2, 3 and 5.
  static constexpr int kStartLevel = 3;

  NormalisedQuery query_;
  int finest_ = 0;
  CellTree trees_[2];
  Tiers tiers_;

  // The split at hand.
  Window window_{};                       ///< where the parents may touch
  std::array<std::uint8_t, 2> depths_{};  ///< how deep the children are
  HeightErrorBound error_;                ///< E of Law C for the children
  bool newton_ = false;                   ///< the parents are coarse enough for it
  bool coarse_ = false;                   ///< the children will be split further
  Children children_[2];
  SharedAxes coordinate_, shared_;
  alignas(32) SnapshotValues values_[2];  ///< for a pair in its own window
};

}  // namespace ccdfuzz::certified
