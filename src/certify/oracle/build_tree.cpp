#include "certify/oracle/build_tree.hpp"

#include <bit>
#include <cmath>

#include "base/fp_guard.hpp"
#include "base/time_limit.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/pair_axes.hpp"
#include "ccd/certified/window_trim.hpp"
#include "certify/checker/miss_tree.hpp"

// The builder is made of the parts of `certified`.
namespace ccdfuzz::certified {

namespace {

using Node = CellTree::Node;

/// The direction's multiple with a largest component of 2^bits, rounded; zero stays zero.
TreeAxis rounded(const Axis& l, int bits) {
  const double largest = std::max({std::abs(l[0]), std::abs(l[1]), std::abs(l[2])});
  TreeAxis out{};
  if (!(largest > 0) || !std::isfinite(largest)) return out;
  for (size_t k = 0; k < 3; ++k) {
    out[k] = static_cast<std::int64_t>(std::lround(std::ldexp(l[k] / largest, bits)));
  }
  return out;
}

Axis to_double(const TreeAxis& l) {
  return {static_cast<double>(l[0]), static_cast<double>(l[1]), static_cast<double>(l[2])};
}

class Builder {
 public:
  Builder(const Query& query, const Rational& until, std::uint64_t max_nodes)
      : nodes_left_(max_nodes) {
    Query horizon = query;
    horizon.t_max = round_up(until);
    normalise(horizon, query_);
    until_ = query_.t_max;
    for (int s = 0; s < 2; ++s) {
      trees_[s].trim(query.patches[s]);
      trees_[s].reset(query_.shapes[s], query_.controls[s], query_.weights[s]);
    }
  }

  std::optional<MissTree> run(const Rational& until) {
    if (!node({{0, 0}, 0, kTimeSteps, {}, 0})) return std::nullopt;
    std::string bytes = bits_.bytes();
    if (bytes.size() > MissTree::kMaxBytes) return std::nullopt;
    return MissTree{until, {std::move(bytes)}};
  }

 private:
  struct Pair {
    std::array<Node, 2> cells;
    std::uint64_t lo, hi;
    Axis hint;
    int level;
  };

  /// The longest stretch at one end of a window that an axis separates.
  struct Cut {
    TreeAxis axis{};
    std::uint64_t time = 0;
    bool low = true;
    std::uint64_t length = 0;
  };

  /// Axes are tried with few bits first: most leaves need no more. The last is the last power of
  /// two that the format has room for. A flat pair that misses by m is split until its size is
  /// below m·2^bits, so each bit less is four times as many leaves.
  static constexpr std::array<int, 6> kBits = {4, 8, 13, 19, 28, 30};
  /// Cuts shorter than 1/8 of the window are not written: the children cut again anyway.
  static constexpr std::uint64_t kLeastCutInverse = 8;
  static constexpr int kTimeBits = std::countr_zero(kTimeSteps);

  /// The time at m. `round_up` costs up to 2u and the product u: three roundings. One of them is
  /// the chord's in HeightErrorBound, which no certified axis here uses; kOfTime counts the others.
  double time(std::uint64_t m) const {
    return until_ * std::ldexp(static_cast<double>(m), -kTimeBits);
  }
  double bound(const Pair& pair, const Axis& l) const {
    constexpr int kOfTime = 2;
    int roundings = 0;
    for (int s = 0; s < 2; ++s) {
      const CellTree& tree = trees_[s];
      roundings = std::max(roundings, tree.roundings(tree.depth(pair.cells[s])));
    }
    return HeightErrorBound(query_.magnitude, query_.absolute,
                            query_.roundings + roundings + kOfTime, query_.separation)
        .for_axis(l);
  }
  HeightLines lines_of(const Pair& pair, const Axis& l) const {
    return {{{trees_[0].net(pair.cells[0]), trees_[1].net(pair.cells[1])},
             {trees_[0].count(), trees_[1].count()}},
            l};
  }
  Gaps gaps(const HeightLines& lines, std::uint64_t lo, std::uint64_t hi) const {
    const Window w{time(lo), time(hi)};
    const auto at = [&](double t) {
      return std::array{lines.gap(0, t).height, lines.gap(1, t).height};
    };
    return {at(w.lo), at(w.hi), {w, 0}};
  }

  /// An axis of few bits near l that certainly separates throughout [lo, hi], patch 1 below.
  std::optional<TreeAxis> certified_axis(const Pair& pair, const Axis& l, std::uint64_t lo,
                                         std::uint64_t hi) const {
    for (const int bits : kBits) {
      TreeAxis axis = rounded(l, bits);
      const Axis exact_axis = to_double(axis);
      const Gaps g = gaps(lines_of(pair, exact_axis), lo, hi);
      const double e = bound(pair, exact_axis);
      for (int sign = 0; sign < 2; ++sign) {
        if (!(g.at_lo[sign] < -e && g.at_hi[sign] < -e)) continue;
        if (sign == 1) {
          for (std::int64_t& x : axis) x = -x;
        }
        return axis;
      }
    }
    return std::nullopt;
  }

  /// What of the window's ends the axis separates, if it is more than the best so far.
  void try_cut(const Pair& pair, const Axis& l, const HeightLines& lines, const Gaps& g, double e,
               Cut& best) const {
    for (int sign = 0; sign < 2; ++sign) {
      const bool low = g.at_lo[sign] < -e;
      if (!low && !(g.at_hi[sign] < -e)) continue;
      Window w{time(pair.lo), time(pair.hi)};
      trim_by_chord(g, e, w);  // first: the gaps are those at the ends of w
      trim_by_newton(lines, e, sign, low, Window(w), w);
      const double steps = std::ldexp((low ? w.lo : w.hi) / until_, kTimeBits);
      std::uint64_t m = static_cast<std::uint64_t>(
          std::clamp(low ? std::floor(steps) : std::ceil(steps), static_cast<double>(pair.lo),
                     static_cast<double>(pair.hi)));
      // Round the cut inward by at most 1/16 of its length, to save bits.
      const std::uint64_t length = low ? m - pair.lo : pair.hi - m;
      if (length * kLeastCutInverse < pair.hi - pair.lo || length <= best.length) continue;
      const std::uint64_t grid = std::bit_floor(std::max<std::uint64_t>(length / 16, 1));
      m = low ? m / grid * grid : (m + grid - 1) / grid * grid;
      if (m <= pair.lo || m >= pair.hi) continue;
      const auto axis =
          low ? certified_axis(pair, l, pair.lo, m) : certified_axis(pair, l, m, pair.hi);
      if (axis) best = {*axis, m, low, length};
    }
  }

  bool leaf(const TreeAxis& axis) {
    bits_.leaf(axis);
    return true;
  }

  bool node(Pair pair) {
    if (nodes_left_ == 0 || pair.level > kMaxTreeDepth / 2) return false;
    TimeLimit::stop_if_late();
    --nodes_left_;
    Cut cut;
    std::optional<TreeAxis> found;
    const auto try_axis = [&](const Axis& l) {
      const HeightLines lines = lines_of(pair, l);
      const Gaps g = gaps(lines, pair.lo, pair.hi);
      const double e = bound(pair, l);
      if (g.separated(e)) {
        found = certified_axis(pair, l, pair.lo, pair.hi);
        if (found) return true;
      }
      if (pair.lo < pair.hi && until_ > 0) try_cut(pair, l, lines, g, e, cut);
      return false;
    };
    if (norm1(pair.hint) > 0 && try_axis(pair.hint)) return leaf(*found);
    for (size_t k = 0; k < 3; ++k) {
      if (try_axis(coordinate_axis(static_cast<int>(k)))) return leaf(*found);
    }
    const double middle = 0.5 * time(pair.lo) + 0.5 * time(pair.hi);
    CandidateAxes candidates({trees_[0], pair.cells[0], middle}, {trees_[1], pair.cells[1], middle},
                             query_.separation > 0);
    for (int r = 0; r < CandidateAxes::kMost; ++r) {
      const Axis l = candidates[r];
      if (norm1(l) > 0 && try_axis(l)) return leaf(*found);
    }

    if (cut.length > 0) {
      pair.hint = to_double(cut.axis);
      Pair rest = pair;
      ++rest.level;
      (cut.low ? rest.lo : rest.hi) = cut.time;
      bits_.time(cut.time);
      if (cut.low) return leaf(cut.axis) && node(rest);
      return node(rest) && leaf(cut.axis);
    }
    return split(pair, middle);
  }

  /// The larger part that can be split, is.
  bool split(const Pair& pair, double t) {
    int side = -1;
    double largest = -1;
    for (int s = 0; s < 2; ++s) {
      const CellTree& tree = trees_[s];
      if (tree.shape().kind == ShapeKind::kPoint) continue;
      if (tree.depth(pair.cells[s]) >= Cell::kMaxDepth) continue;
      double size = 0;
      for (size_t k = 0; k < 3; ++k) {
        const Range range = lines_of(pair, coordinate_axis(static_cast<int>(k))).extent(s, t);
        size = std::max(size, range.max - range.min);
      }
      if (size > largest) largest = size, side = s;
    }
    if (side < 0) return false;
    bits_.split(side);
    const Node first = trees_[side].children(pair.cells[side]);
    const unsigned outside = trees_[side].outside(pair.cells[side]);
    for (int c = 0; c < trees_[side].shape().child_count(); ++c) {
      if ((outside >> c & 1) != 0) {
        bits_.outside(side);
        continue;
      }
      Pair child = pair;
      ++child.level;
      child.cells[side] = first + static_cast<Node>(c);
      if (!node(child)) return false;
    }
    return true;
  }

  NormalisedQuery query_;
  CellTree trees_[2];
  double until_ = 0;
  TreeBits bits_;
  std::uint64_t nodes_left_;
};

}  // namespace

}  // namespace ccdfuzz::certified

namespace ccdfuzz {

std::optional<MissTree> build_miss_tree(const Query& query, const Rational& until,
                                        std::uint64_t max_nodes) {
  const FpGuard guard;
  return certified::Builder(query, until, max_nodes).run(until);
}

}  // namespace ccdfuzz
