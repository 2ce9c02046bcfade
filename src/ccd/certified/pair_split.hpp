#pragma once

#include <algorithm>
#include <array>

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

  /// A pair of children, what is left of its window, and the axis that did most for it.
  struct Kept {
    Window window;
    Axis hint;
    std::array<Node, 2> cells;
    std::array<int, 2> children;  ///< which child each cell is of its parent
  };

  void begin(const Query& query);

  const NormalisedQuery& query() const { return query_; }
  const CellTree& tree(int side) const { return trees_[side]; }
  size_t bytes() const { return trees_[0].bytes() + trees_[1].bytes(); }

  /// Splits a pair and calls keep(Kept) for each pair of children that may touch, in the order of
  /// their places. pair: window, hint, cells[2] and depth. wanted(side, child) says which children
  /// to look at. observer: Unobserved or an ExclusionObserver; its axes are 0..2 the coordinate
  /// axes, 3 the parent's hint, 4 and 5 the parents' normals, from 6 those of CandidateAxes.
  template <class Pair, class Wanted, class Observer, class Keep>
  void expand(const Pair& pair, const Wanted& wanted, Observer& observer, const Keep& keep);

 private:
  /// The control points of a snapshot.
  using SnapshotValues = std::array<double, 6 * ((kMaxControls + kLanes - 1) / kLanes * kLanes)>;

  struct Child {
    Node node;
    bool has_shared;
    ComponentRanges coordinate;
    RangeBatch shared;
    alignas(32) SnapshotValues values;
  };
  /// The axes that all pairs of children share, and the error bounds on them: 0..2 on the
  /// coordinate axes, 3..5 on `axes`.
  struct Shared {
    Axis axes[3];
    AxisBatch batch;
    double bound[6];
    ErrorBound error;
  };

  Snapshot snapshot(int side, const SnapshotValues& values) const {
    return {values.data(), trees_[side].width(), query_.shapes[side].control_count()};
  }

  template <class Observer>
  bool narrow(const Child& a, const Child& b, const Shared& shared, Observer& observer, Window& w,
              Axis& hint);
  template <class Observer>
  bool narrow_by_own_axes(const Child& a, const Child& b, const Shared& shared, Observer& observer,
                          const Window& parent, Window& w, Axis& hint);

  NormalisedQuery query_;
  CellTree trees_[2];
  Child children_[2][4];
  alignas(32) SnapshotValues values_[2];  ///< of a pair in its own window
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

template <class Pair, class Wanted, class Observer, class Keep>
void PairSplit::expand(const Pair& pair, const Wanted& wanted, Observer& observer,
                       const Keep& keep) {
  const double middle = 0.5 * pair.window.lo + 0.5 * pair.window.hi;
  const Skeleton whole[2] = {{trees_[0], pair.cells[0], middle},
                             {trees_[1], pair.cells[1], middle}};
  Shared shared{{pair.hint, whole[0].normal, whole[1].normal}, {}, {}, {}};
  shared.error = ErrorBound(
      query_.magnitude, query_.absolute,
      std::max(trees_[0].roundings(pair.depth + 1), trees_[1].roundings(pair.depth + 1)));
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) shared.batch.axes[j][k] = shared.axes[k][j];
    shared.bound[k] = shared.error.for_axis(1.0);
    shared.bound[k + 3] = shared.error.for_axis(norm1(shared.axes[k]));
  }

  for (int s = 0; s < 2; ++s) {
    const Node first = trees_[s].children(pair.cells[s]);
    for (int c = 0; c < query_.shapes[s].child_count(); ++c) {
      if (!wanted(s, c)) continue;
      Child& child = children_[s][c];
      child.node = first + static_cast<Node>(c);
      child.has_shared = false;
      take_snapshot(trees_[s].net(child.node), trees_[s].width(), pair.window.lo, pair.window.hi,
                    child.values.data());
      component_ranges(snapshot(s, child.values), child.coordinate);
    }
  }
  for (int a = 0; a < query_.shapes[0].child_count(); ++a) {
    if (!wanted(0, a)) continue;
    for (int b = 0; b < query_.shapes[1].child_count(); ++b) {
      if (!wanted(1, b)) continue;
      Child* const two[2] = {&children_[0][a], &children_[1][b]};
      bool apart = false;
      for (int k = 0; k < 3 && !apart; ++k) {
        const Gaps gaps(component(two[0]->coordinate, k), component(two[1]->coordinate, k));
        if constexpr (Observer::kListens) {
          const Axis l = detail::coordinate_axis(k);
          detail::Told{observer, k, l}.compared(gaps, shared.bound[k], pair.window);
        }
        apart = gaps.separated(shared.bound[k]);
      }
      if (apart) continue;
      for (int s = 0; s < 2; ++s) {
        if (two[s]->has_shared) continue;
        two[s]->has_shared = true;
        project(snapshot(s, two[s]->values), shared.batch, two[s]->shared);
      }
      Window w = pair.window;
      Axis hint = pair.hint;
      if (narrow(*two[0], *two[1], shared, observer, w, hint)) {
        keep(Kept{w, hint, {two[0]->node, two[1]->node}, {a, b}});
      }
    }
  }
}

/// Shortens w by every axis in turn. Returns false if the pair is separated throughout.
template <class Observer>
bool PairSplit::narrow(const Child& a, const Child& b, const Shared& shared,
                       [[maybe_unused]] Observer& observer, Window& w, Axis& hint) {
  const Window parent = w;
  for (int k = 0; k < 3; ++k) {
    const Gaps gaps(lane(a.shared, k), lane(b.shared, k));
    if constexpr (Observer::kListens) {
      detail::Told{observer, 3 + k, shared.axes[k]}.compared(gaps, shared.bound[k + 3], parent);
    }
    if (gaps.separated(shared.bound[k + 3])) return false;
  }
  const auto trim = [&]([[maybe_unused]] int axis, const Gaps& gaps, double e) {
    if (!gaps.separated_at_an_end(e)) return;
    Window trimmed = parent;
    trim_by_chord(gaps, e, trimmed);
    w = detail::intersection(w, trimmed);
    if constexpr (Observer::kListens) {
      const Axis l = axis < 3 ? detail::coordinate_axis(axis) : shared.axes[axis - 3];
      detail::Told{observer, axis, l}.trimmed(gaps, e, parent, trimmed);
    }
  };
  for (int k = 0; k < 3; ++k) {
    trim(k, Gaps(component(a.coordinate, k), component(b.coordinate, k)), shared.bound[k]);
    trim(k + 3, Gaps(lane(a.shared, k), lane(b.shared, k)), shared.bound[k + 3]);
  }
  if (w.lo > w.hi) return false;  // what two axes exclude covers the window
  return narrow_by_own_axes(a, b, shared, observer, parent, w, hint);
}

/// The same by the axes of the pair itself.
template <class Observer>
bool PairSplit::narrow_by_own_axes(const Child& a, const Child& b, const Shared& shared,
                                   [[maybe_unused]] Observer& observer, const Window& parent,
                                   Window& w, Axis& hint) {
  const NetPair nets = {{trees_[0].net(a.node), trees_[1].net(b.node)},
                        {trees_[0].width(), trees_[1].width()}};
  // The nets at both ends of `seen`.
  Snapshot now[2] = {snapshot(0, a.values), snapshot(1, b.values)};
  Window seen = parent;
  const auto look = [&] {
    if (seen.lo == w.lo && seen.hi == w.hi) return;
    seen = w;
    for (int s = 0; s < 2; ++s) {
      take_snapshot(nets.net[s], nets.width[s], w.lo, w.hi, values_[s].data());
      now[s] = snapshot(s, values_[s]);
    }
  };
  look();
  const Skeleton flat_a(query_.shapes[0], now[0]), flat_b(query_.shapes[1], now[1]);
  CandidateAxes candidates(flat_a, flat_b);
  for (int i = 0; const AxisBatch* batch = candidates.batch(i); ++i) {
    look();
    RangeBatch ranges[2];
    for (int s = 0; s < 2; ++s) project(now[s], *batch, ranges[s]);
    for (int j = 0; j < kLanes; ++j) {
      const Axis l = {batch->axes[0][j], batch->axes[1][j], batch->axes[2][j]};
      const double e = shared.error.for_axis(norm1(l));
      const Gaps gaps(lane(ranges[0], j), lane(ranges[1], j));
      [[maybe_unused]] const int axis = 6 + i * kLanes + j;
      if constexpr (Observer::kListens) detail::Told{observer, axis, l}.compared(gaps, e, seen);
      if (gaps.separated(e)) return false;
      if (!gaps.separated_at_an_end(e)) continue;
      Window trimmed = seen;
      trim_by_chord(gaps, e, trimmed);
      const HeightLines lines(nets, l);
      for (int sign = 0; sign < 2; ++sign) {
        const bool low = gaps.at_lo[sign] < -e, high = gaps.at_hi[sign] < -e;
        if (low || high) trim_by_newton(lines, e, sign, low, trimmed);
      }
      if constexpr (Observer::kListens) {
        detail::Told{observer, axis, l}.trimmed(gaps, e, seen, trimmed);
      }
      w = detail::intersection(w, trimmed);
      hint = l;
      if (w.lo > w.hi) return false;  // several axes together exclude all of it
    }
  }
  return true;
}

}  // namespace ccdfuzz::certified
