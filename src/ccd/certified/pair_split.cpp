#include "ccd/certified/pair_split.hpp"

#include <algorithm>
#include <bit>

#include "base/verify.hpp"

namespace ccdfuzz::certified {

namespace {

/// An axis, and the observer that is told of it.
struct ObservedAxis {
  ExclusionObserver& observer;
  int number;
  Axis l;

  Vec3<double> direction() const { return {l[0], l[1], l[2]}; }

  void excluded(int below, const SeparatedInterval<double>& times) const {
    observer.excluded({number, direction(), below, times});
  }

  /// The gaps at both ends of w, and that all of w is excluded if it is.
  void compared(const Gaps& gaps, double bound, const Window& w) const {
    for (int below = 0; below < 2; ++below) {
      observer.compared({number, direction(), below, w, gaps.at_lo[below] + bound,
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

void set_axis(AxisBatch& batch, size_t lane, const Axis& l) {
  for (size_t k = 0; k < 3; ++k) batch.axes[k][lane] = l[k];
}

}  // namespace

void PairSplit::begin(int finest) {
  finest_ = finest;
  for (int s = 0; s < 2; ++s)
    trees_[s].reset(query_.shapes[s], query_.controls[s], query_.weights[s]);
  coordinate_.first = 0;
  coordinate_.axes = {};
  for (int k = 0; k < 3; ++k)
    set_axis(coordinate_.axes, static_cast<size_t>(k), coordinate_axis(k));
  shared_.first = 3;
  shared_.axes = {};
}

/// The children that are wanted, and what all of their pairs share.
void PairSplit::prepare(const CellPair& pair, const std::array<unsigned, 2>& wanted) {
  window_ = pair.window;
  CCDFUZZ_ASSERT(window_.lo <= window_.hi);
  const double middle = 0.5 * window_.lo + 0.5 * window_.hi;
  const CornerFrame whole[2] = {{trees_[0], pair.cells[0], middle},
                                {trees_[1], pair.cells[1], middle}};
  newton_ = pair.least_depth() < kNewtonLevels;
  for (size_t s = 0; s < 2; ++s) {
    Children& children = children_[s];
    const bool splits = pair.depths[s] <= pair.depths[1 - s];
    CCDFUZZ_ASSERT(query_.shapes[s].kind == ShapeKind::kPoint ||
                   trees_[s].depth(pair.cells[s]) == pair.depths[s]);
    depths_[s] = static_cast<std::uint8_t>(pair.depths[s] + (splits ? 1 : 0));
    children.first = splits ? trees_[s].children(pair.cells[s]) : pair.cells[s];
    const int count = splits ? query_.shapes[s].child_count() : 1;
    children.wanted = wanted[s] & ((1U << count) - 1);
    if (splits) children.wanted &= ~trees_[s].outside(pair.cells[s]);
    for (unsigned left = children.wanted; left != 0; left &= left - 1) {
      const int c = std::countr_zero(left);
      const Node child = node(static_cast<int>(s), c);
      take_snapshot(trees_[s].net(child), trees_[s].count(), window_.lo, window_.hi,
                    children.values[c].data(), &coordinate_.extents[s][c]);
      coordinate_.extents[s][c].of = provenance(static_cast<int>(s), child, window_);
    }
  }
  coarse_ = std::min(depths_[0], depths_[1]) < finest_;
  const int roundings = std::max(trees_[0].roundings(depths_[0]), trees_[1].roundings(depths_[1]));
  error_ = HeightErrorBound(query_.magnitude, query_.absolute, query_.roundings + roundings,
                            query_.separation);
  coordinate_.bounds = error_.for_axes(coordinate_.axes);
  const std::array<Axis, kLanes> axes = {pair.hint, whole[0].normal, whole[1].normal, Axis{}};
  for (size_t i = 0; i < kLanes; ++i) set_axis(shared_.axes, i, axes[i]);
  shared_.bounds = error_.for_axes(shared_.axes);
}

int PairSplit::split(const CellPair& pair, const std::array<unsigned, 2>& wanted,
                     std::span<CellPair, kMostPairs> kept, ExclusionObserver* observer) {
  prepare(pair, wanted);
  unsigned pairs = 0;  // bit 4·a + b
  for (int a = 0; a < 4; ++a) {
    if ((children_[0].wanted >> a & 1) != 0) pairs |= children_[1].wanted << (4 * a);
  }
  const unsigned all = pairs;
  pairs = test(coordinate_, all, observer);
  const unsigned after_coordinate = pairs;
  unsigned left[2] = {0, 0};  // the children that these pairs have
  for (int a = 0; a < 4; ++a) {
    const unsigned row = (pairs >> (4 * a)) & 15;
    if (row != 0) left[0] |= 1U << a;
    left[1] |= row;
  }
  for (int s = 0; s < 2; ++s) {
    for (; left[s] != 0; left[s] &= left[s] - 1) {
      const int c = std::countr_zero(left[s]);
      project(snapshot(s, c), shared_.axes, shared_.extents[s][c]);
    }
  }
  pairs = test(shared_, pairs, observer);
  tiers_.coordinate += after_coordinate != all;
  tiers_.shared += pairs != after_coordinate;
  int count = 0;
  for (; pairs != 0; pairs &= pairs - 1) {
    const int a = std::countr_zero(pairs) / 4, b = std::countr_zero(pairs) % 4;
    CellPair& one = kept[static_cast<size_t>(count)];
    // One by one: a copy of the whole would wait for these stores.
    one.hint = pair.hint;
    one.cells = {node(0, a), node(1, b)};
    one.depths = depths_;
    if (!narrow(a, b, observer, one)) continue;
    CCDFUZZ_ASSERT(window_.lo <= one.window.lo && one.window.lo <= one.window.hi &&
                   one.window.hi <= window_.hi);
    ++count;
  }
  return count;
}

/// The pairs that no shared axis separates throughout.
unsigned PairSplit::test(const SharedAxes& shared, unsigned pairs,
                         ExclusionObserver* observer) const {
  for (unsigned left = observer != nullptr ? pairs : 0; left != 0; left &= left - 1) {
    const int pair = std::countr_zero(left);
    for (int k = 0; k < 3; ++k) {
      const Gaps gaps = gaps_of(shared.extents[0][pair / 4], shared.extents[1][pair % 4], k);
      const double bound = shared.bounds.on[static_cast<size_t>(k)];
      ObservedAxis{*observer, shared.first + k, axis_of(shared.axes, k)}.compared(gaps, bound,
                                                                                  window_);
      if (gaps.separated(bound)) break;
    }
  }
  return not_separated(shared.extents[0], shared.extents[1], pairs, shared.bounds);
}

/// What every shared axis leaves of w, each by what it separates of the parents' window.
[[gnu::always_inline]] inline Window PairSplit::trim(const SharedAxes& shared, int a, int b,
                                                     ExclusionObserver* observer, Window w) {
  const RangeBatch &of_a = shared.extents[0][a], &of_b = shared.extents[1][b];
  for (unsigned ends = compare(of_a, of_b, shared.bounds).at_an_end; ends != 0; ends &= ends - 1) {
    const int k = std::countr_zero(ends);
    const double bound = shared.bounds.on[static_cast<size_t>(k)];
    const Gaps gaps = gaps_of(of_a, of_b, k);
    Window trimmed = window_;
    trim_by_chord(gaps, bound, trimmed);
    ++tiers_.chord;
    w = intersection(w, trimmed);
    if (observer != nullptr) {
      ObservedAxis{*observer, shared.first + k, axis_of(shared.axes, k)}.trimmed(gaps, bound,
                                                                                 window_, trimmed);
    }
  }
  return w;
}

/// Shortens the window of a pair, which no shared axis separates throughout, by every axis in turn:
/// the shared ones, then those of the pair itself. Returns false if the pair is separated
/// throughout.
bool PairSplit::narrow(int a, int b, ExclusionObserver* observer, CellPair& kept) {
  Window& w = kept.window;
  w = trim(shared_, a, b, observer, trim(coordinate_, a, b, observer, window_));
  if (w.lo > w.hi) return drop_together(w);  // what two axes exclude covers the window
  const NetPair nets = {{trees_[0].net(kept.cells[0]), trees_[1].net(kept.cells[1])},
                        {trees_[0].count(), trees_[1].count()}};
  Window seen = window_;
  std::array<Snapshot, 2> at_ends = {snapshot(0, a), snapshot(1, b)};
  const auto look_again = [&] {
    if (seen.lo == w.lo && seen.hi == w.hi) return;
    seen = w;
    for (int s = 0; s < 2; ++s) {
      take_snapshot(nets.net[s], nets.count[s], w.lo, w.hi, values_[s].data());
      CCDFUZZ_ASSERT(!query_.weights[static_cast<size_t>(s)].empty() ||
                     values_[s][4] == nets.net[s][0] + w.hi * nets.net[s][4]);
      at_ends[s] = {values_[s].data(), nets.count[s], provenance(s, kept.cells[s], w)};
    }
  };
  look_again();
  const bool is_coarse = std::min(depths_[0], depths_[1]) < kStartLevel;
  const double way = query_.separation == 0 || is_coarse ? 0.5 : 0;
  CandidateAxes candidates({query_.shapes[0], at_ends[0], way}, {query_.shapes[1], at_ends[1], way},
                           query_.separation > 0);
  for (int i = 0; const AxisBatch* batch = candidates.batch(i); ++i) {
    look_again();
    CCDFUZZ_ASSERT(!(seen.lo != w.lo || seen.hi != w.hi));
    const Bounds bounds = error_.for_axes(*batch);
    std::array<RangeBatch, 2> ranges;
    const SeparatingAxes separating =
        project_and_compare(at_ends[0], at_ends[1], *batch, bounds, ranges);
    const auto gaps_on = [&](int k) { return gaps_of(ranges[0], ranges[1], k); };
    const auto observed = [&](int k) {
      return ObservedAxis{*observer, kFirstOwnAxis + i * kLanes + k, axis_of(*batch, k)};
    };
    for (int k = 0; k < kLanes && observer != nullptr; ++k) {
      observed(k).compared(gaps_on(k), bounds.on[static_cast<size_t>(k)], seen);
    }
    if (separating.throughout != 0) {
      ++tiers_.own;
      return false;
    }
    for (unsigned ends = separating.at_an_end; ends != 0; ends &= ends - 1) {
      const int k = std::countr_zero(ends);
      const double bound = bounds.on[static_cast<size_t>(k)];
      const Gaps gaps = gaps_on(k);
      Window trimmed = seen;
      trim_by_chord(gaps, bound, trimmed);
      ++tiers_.chord;
      if (newton_) {
        const HeightLines lines(nets, axis_of(*batch, k));
        const Window by_chord = trimmed;
        for (int sign = 0; sign < 2; ++sign) {
          const bool low = gaps.at_lo[sign] < -bound, high = gaps.at_hi[sign] < -bound;
          if (low || high) {
            tiers_.newton += trim_by_newton(lines, bound, sign, low, by_chord, trimmed);
          }
        }
      }
      if (observer != nullptr) observed(k).trimmed(gaps, bound, seen, trimmed);
      w = intersection(w, trimmed);
      kept.hint = axis_of(*batch, k);
      if (w.lo > w.hi) return drop_together(w);  // several axes together exclude all of it
    }
    // If the first batch helped at neither end, the rest rarely does. Go on with the children,
    // unless this is the finest depth.
    if (coarse_ && i == 0 && w.lo == window_.lo && w.hi == window_.hi) {
      ++tiers_.postponed;
      break;
    }
  }
  return true;
}

}  // namespace ccdfuzz::certified
