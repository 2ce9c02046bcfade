#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "ccd/certified/cell_tree.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/pair_axes.hpp"
#include "ccd/certified/window_trim.hpp"
#include "ccd/exclusion.hpp"
#include "ccd/search.hpp"

namespace ccdfuzz::certified {

/// The inclusion test of tdibm-c (DERIVATION.md): splits a pair of cells and finds for each pair of
/// their children the part of the window in which no axis certifies them apart.
/// Guarantee: a time at which two children touch is never taken from their window, nor the pair
/// dropped. One object serves one thread and keeps its buffers between queries.
class PairSplit {
 public:
  using Node = CellTree::Node;

  /// The axes before it, all pairs of children share: 0..2 are the coordinate axes, 3 the parent's
  /// hint, 4 and 5 the parents' normals. From it on they are those of CandidateAxes.
  static constexpr int kFirstOwnAxis = 6;

  /// A pair of children, what is left of its window, and the axis that did most for it.
  struct Kept {
    Window window;
    Axis hint;
    std::array<Node, 2> cells;
    std::array<int, 2> children;  ///< which child each cell is of its parent
  };

  /// finest: the depth to which pairs will be split. Children above it are not put to all axes if
  /// it looks futile; that can cost further splits, never a proof.
  void begin(const Query& query, int finest);

  const NormalisedQuery& query() const { return query_; }
  const CellTree& tree(int side) const { return trees_[side]; }
  /// Bytes of all cells, and of the memory that is held for them.
  size_t bytes() const { return trees_[0].bytes() + trees_[1].bytes(); }
  size_t held() const { return trees_[0].held() + trees_[1].held(); }
  void clear() {
    for (CellTree& tree : trees_) tree.clear();
  }
  void keep_at_most(size_t bytes) {
    for (CellTree& tree : trees_) tree.keep_at_most(bytes / 2);
  }

  /// Splits a pair and calls keep(Kept) for each pair of children that may touch, in the order of
  /// their places. pair: window, hint, cells[2] and depth. wanted(side, child) says which children
  /// to look at. observer: Unobserved or an ExclusionObserver.
  template <class Pair, class Wanted, class Observer, class Keep>
  void expand(const Pair& pair, const Wanted& wanted, Observer& observer, const Keep& keep);

 private:
  /// The control points of a snapshot.
  using SnapshotValues = std::array<double, kPerPoint * kMaxControls>;

  /// The children of a cell.
  struct Children {
    Node first;
    unsigned wanted;  ///< bit c for child c
    unsigned shared;  ///< those that have their extents on the shared axes
    RangeBatch on_coordinates[4], on_shared[4];
    alignas(32) SnapshotValues values[4];
  };
  /// The axes that all pairs of children share, and the error bounds on them.
  struct Shared {
    AxisBatch batch;  ///< the last lane is none
    Lanes bounds, coordinate_bounds;
    ErrorBound error;
    int level;    ///< depth of the parents
    bool coarse;  ///< the pairs will be split further
  };

  Snapshot snapshot(int side, const SnapshotValues& values) const {
    return {values.data(), trees_[side].count()};
  }

  Node node(int side, int child) const { return children_[side].first + static_cast<Node>(child); }
  /// Gives children their extents on the shared axes.
  void share(int side, unsigned children, const Shared& shared) {
    Children& all = children_[side];
    for (unsigned left = children & ~all.shared; left != 0; left &= left - 1) {
      const int c = std::countr_zero(left);
      project(snapshot(side, all.values[c]), shared.batch, all.on_shared[c]);
    }
    all.shared |= children;
  }

  template <class Pair, class Wanted>
  void prepare(const Pair& pair, const Wanted& wanted, Shared& shared);
  template <class Observer>
  bool narrow(int a, int b, const Shared& shared, Observer& observer, Window& w, Axis& hint);
  template <class Observer>
  bool narrow_by_own_axes(int a, int b, const Shared& shared, Observer& observer,
                          const Window& parent, Window& w, Axis& hint);

  /// Deeper down windows are so short that h is almost a line, whose root the chord finds.
  static constexpr int kNewtonLevels = 3;

  NormalisedQuery query_;
  int finest_ = 0;
  CellTree trees_[2];
  Children children_[2];
  alignas(32) SnapshotValues values_[2];  ///< for a pair in its own window
};

namespace detail {

inline Vec3<double> direction_of(const Axis& l) {
  return {l[0], l[1], l[2]};
}

inline Window intersection(const Window& v, const Window& w) {
  return {std::max(v.lo, w.lo), std::min(v.hi, w.hi)};
}

inline Axis coordinate_axis(int k) {
  Axis l{};
  l[static_cast<size_t>(k)] = 1;
  return l;
}

/// An axis as a listener is told of it.
struct Told {
  ExclusionObserver& observer;
  int axis;
  const Axis& l;

  void excluded(int below, const Separation<double>& times) const {
    observer.excluded({axis, direction_of(l), below, times});
  }

  /// The gaps at both ends of w, and that all of w is excluded if it is.
  void compared(const Gaps& gaps, double bound, const Window& w) const {
    for (int below = 0; below < 2; ++below) {
      observer.compared({axis, direction_of(l), below, w, gaps.at_lo[below] + bound,
                         gaps.at_hi[below] + bound, bound});
    }
    if (!gaps.separated(bound)) return;
    const int below = gaps.at_lo[0] < -bound && gaps.at_hi[0] < -bound ? 0 : 1;
    excluded(below, {w.lo, w.hi, true, true});
  }

  /// What a trim took from the ends of `before`.
  void trimmed(const Gaps& gaps, double bound, const Window& before, const Window& after) const {
    if (before.lo < after.lo) {
      excluded(gaps.at_lo[0] < -bound ? 0 : 1, {before.lo, after.lo, true, false});
    }
    if (after.hi < before.hi) {
      excluded(gaps.at_hi[0] < -bound ? 0 : 1, {after.hi, before.hi, false, true});
    }
  }
};

}  // namespace detail

/// The children that are wanted, and what all of their pairs share.
template <class Pair, class Wanted>
void PairSplit::prepare(const Pair& pair, const Wanted& wanted, Shared& shared) {
  const double middle = 0.5 * pair.window.lo + 0.5 * pair.window.hi;
  const Skeleton whole[2] = {{trees_[0], pair.cells[0], middle},
                             {trees_[1], pair.cells[1], middle}};
  shared.error = ErrorBound(
      query_.magnitude, query_.absolute,
      std::max(trees_[0].roundings(pair.depth + 1), trees_[1].roundings(pair.depth + 1)));
  const auto add = [&](size_t i, const Axis& l) {
    for (size_t k = 0; k < 3; ++k) shared.batch.axes[k][i] = l[k];
    shared.bounds[i] = shared.error.for_axis(norm1(l));
  };
  add(0, pair.hint);
  add(1, whole[0].normal);
  add(2, whole[1].normal);
  add(3, {});
  shared.coordinate_bounds.fill(shared.error.for_axis(1.0));
  shared.level = pair.depth;
  shared.coarse = pair.depth + 1 < finest_;

  for (int s = 0; s < 2; ++s) {
    Children& children = children_[s];
    children.first = trees_[s].children(pair.cells[s]);
    children.wanted = children.shared = 0;
    for (int c = 0; c < query_.shapes[s].child_count(); ++c) {
      if (!wanted(s, c)) continue;
      children.wanted |= 1U << c;
      take_snapshot(trees_[s].net(node(s, c)), trees_[s].count(), pair.window.lo, pair.window.hi,
                    children.values[c].data(), children.on_coordinates[c]);
    }
  }
}

template <class Pair, class Wanted, class Observer, class Keep>
void PairSplit::expand(const Pair& pair, const Wanted& wanted, Observer& observer,
                       const Keep& keep) {
  Shared shared;
  prepare(pair, wanted, shared);
  unsigned pairs = 0;
  for (int a = 0; a < 4; ++a) {
    if ((children_[0].wanted >> a & 1) != 0) pairs |= children_[1].wanted << 4 * a;
  }
  const auto test = [&](int first_axis, const auto& axis, auto ranges, const Lanes& bounds) {
    if constexpr (Observer::kListens) {
      for (unsigned left = pairs; left != 0; left &= left - 1) {
        const int pair_bit = std::countr_zero(left);
        for (int k = 0; k < 3; ++k) {
          const Gaps gaps(lane((children_[0].*ranges)[pair_bit / 4], k),
                          lane((children_[1].*ranges)[pair_bit % 4], k));
          detail::Told{observer, first_axis + k, axis(k)}.compared(gaps, bounds[k], pair.window);
          if (gaps.separated(bounds[k])) break;
        }
      }
    }
    pairs = together(children_[0].*ranges, children_[1].*ranges, pairs, bounds);
  };
  test(0, detail::coordinate_axis, &Children::on_coordinates, shared.coordinate_bounds);
  for (int a = 0; a < 4; ++a) {
    const unsigned row = pairs >> 4 * a & 15;
    if (row == 0) continue;
    share(0, 1U << a, shared);
    share(1, row, shared);
  }
  test(
      3, [&](int k) { return axis_of(shared.batch, k); }, &Children::on_shared, shared.bounds);
  for (; pairs != 0; pairs &= pairs - 1) {
    const int a = std::countr_zero(pairs) / 4, b = std::countr_zero(pairs) % 4;
    Kept kept{pair.window, pair.hint, {node(0, a), node(1, b)}, {a, b}};
    if (narrow(a, b, shared, observer, kept.window, kept.hint)) keep(kept);
  }
}

/// Shortens w, in which no shared axis separates the pair throughout, by every axis in turn.
/// Returns false if the pair is separated throughout.
template <class Observer>
bool PairSplit::narrow(int a, int b, const Shared& shared, [[maybe_unused]] Observer& observer,
                       Window& w, Axis& hint) {
  const Window parent = w;
  const auto trim = [&](int first_axis, const auto& axis, auto ranges, const Lanes& bounds) {
    const RangeBatch &of_a = (children_[0].*ranges)[a], &of_b = (children_[1].*ranges)[b];
    for (unsigned ends = compare(of_a, of_b, bounds).apart_at_end; ends != 0; ends &= ends - 1) {
      const int k = std::countr_zero(ends);
      const Gaps gaps(lane(of_a, k), lane(of_b, k));
      Window trimmed = parent;
      trim_by_chord(gaps, bounds[k], trimmed);
      w = detail::intersection(w, trimmed);
      if constexpr (Observer::kListens) {
        detail::Told{observer, first_axis + k, axis(k)}.trimmed(gaps, bounds[k], parent, trimmed);
      }
    }
  };
  trim(0, detail::coordinate_axis, &Children::on_coordinates, shared.coordinate_bounds);
  trim(
      3, [&](int k) { return axis_of(shared.batch, k); }, &Children::on_shared, shared.bounds);
  if (w.lo > w.hi) return false;  // what two axes exclude covers the window
  return narrow_by_own_axes(a, b, shared, observer, parent, w, hint);
}

/// The same by the axes of the pair itself.
template <class Observer>
bool PairSplit::narrow_by_own_axes(int a, int b, const Shared& shared,
                                   [[maybe_unused]] Observer& observer, const Window& parent,
                                   Window& w, Axis& hint) {
  const NetPair nets = {{trees_[0].net(node(0, a)), trees_[1].net(node(1, b))},
                        {trees_[0].count(), trees_[1].count()}};
  // The nets at both ends of `seen`.
  Snapshot now[2] = {snapshot(0, children_[0].values[a]), snapshot(1, children_[1].values[b])};
  Window seen = parent;
  const auto look = [&] {
    if (seen.lo == w.lo && seen.hi == w.hi) return;
    seen = w;
    for (int s = 0; s < 2; ++s) {
      take_snapshot(nets.net[s], nets.count[s], w.lo, w.hi, values_[s].data());
      now[s] = snapshot(s, values_[s]);
    }
  };
  look();
  const Skeleton flat_a(query_.shapes[0], now[0]), flat_b(query_.shapes[1], now[1]);
  CandidateAxes candidates(flat_a, flat_b);
  for (int i = 0; const AxisBatch* batch = candidates.batch(i); ++i) {
    look();
    const Lanes bounds = shared.error.for_axes(*batch);
    std::array<RangeBatch, 2> ranges;
    const Verdicts verdicts = project_and_compare(now[0], now[1], *batch, bounds, ranges);
    const auto axis = [&](int k) { return axis_of(*batch, k); };
    const auto gaps_on = [&](int k) { return Gaps(lane(ranges[0], k), lane(ranges[1], k)); };
    const int first_axis = kFirstOwnAxis + i * kLanes;
    if constexpr (Observer::kListens) {
      for (int k = 0; k < kLanes; ++k) {
        detail::Told{observer, first_axis + k, axis(k)}.compared(gaps_on(k), bounds[k], seen);
      }
    }
    if (verdicts.apart != 0) return false;
    for (unsigned ends = verdicts.apart_at_end; ends != 0; ends &= ends - 1) {
      const int k = std::countr_zero(ends);
      const Gaps gaps = gaps_on(k);
      Window trimmed = seen;
      trim_by_chord(gaps, bounds[k], trimmed);
      if (shared.level < kNewtonLevels) {
        const HeightLines lines(nets, axis(k));
        const Window by_chord = trimmed;
        for (int sign = 0; sign < 2; ++sign) {
          const bool low = gaps.at_lo[sign] < -bounds[k], high = gaps.at_hi[sign] < -bounds[k];
          if (low || high) trim_by_newton(lines, bounds[k], sign, low, by_chord, trimmed);
        }
      }
      if constexpr (Observer::kListens) {
        detail::Told{observer, first_axis + k, axis(k)}.trimmed(gaps, bounds[k], seen, trimmed);
      }
      w = detail::intersection(w, trimmed);
      hint = axis(k);
      if (w.lo > w.hi) return false;  // several axes together exclude all of it
    }
    // What none of the likeliest axes separates at either end hardly any other does; the children
    // will tell, unless these are the finest.
    if (shared.coarse && i == 0 && w.lo == parent.lo && w.hi == parent.hi) break;
  }
  return true;
}

}  // namespace ccdfuzz::certified
