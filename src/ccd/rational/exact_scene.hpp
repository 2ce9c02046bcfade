#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/double_parts.hpp"
#include "base/verify.hpp"
#include "bezier/blossom.hpp"
#include "bezier/cell.hpp"
#include "ccd/rational/axis.hpp"
#include "ccd/rational/units.hpp"
#include "numeric/rational.hpp"
#include "numeric/wide_int.hpp"

namespace ccdfuzz::exact_ccd {

/// parts·2^-unit as an integer. Requires parts.exponent ≥ unit or parts = 0.
template <class Int>
Int integer_in(const DoubleParts& parts, int unit) {
  if (parts.mantissa == 0) return Int(0);
  return Int(Int(static_cast<long>(parts.mantissa)) << (parts.exponent - unit));
}

/// One query in integers of type Int, a WideInt, or Integer for any size. It decides the exact sign
/// of the gap of two cells along an axis at a time.
/// Int must hold Units::bits_needed bits for every predicate asked; of rational patches it is
/// Integer.
template <class Int>
class ExactScene {
 public:
  /// Operations on 64-bit words so far, over the life of the object.
  std::uint64_t work() const { return work_; }

  /// Allocates only when the query has more control points than any before.
  void load(const Query& query, const Units& units) {
    units_ = units;
    is_rational_ = is_rational(query);
    CCDFUZZ_VERIFY(!is_rational_ || kHoldsAll);
    separation_ = integer_in<Int>(parts_of(query.separation), units.length);
    for (size_t side = 0; side < 2; ++side) {
      const MovingPatch<double>& patch = query.patches[side];
      Side& s = sides_[side];
      s.shape = patch.shape;
      const size_t count = patch.positions.size();
      s.controls.resize(count);
      for (Part& part : s.parts) {
        part.cell.depth = kNoDepth;
        if (part.points.size() < count) part.points.resize(count);
      }
      if (net_.size() < count) net_.resize(count);
      for (size_t i = 0; i < count; ++i) {
        Control& control = s.controls[i];
        control[kWeight] = Int(1);
        for (size_t k = 0; k < 3; ++k) {
          const DoubleParts position = parts_of(patch.positions[i][static_cast<int>(k)]);
          control[k] = integer_in<Int>(position, units.length);
          const int unit = units.length - units.time;
          control[k + 3] = integer_in<Int>(parts_of(patch.moves()[i][static_cast<int>(k)]), unit);
          if (patch.has_ends()) control[k + 3] -= integer_in<Int>(position, unit);
        }
      }
      if constexpr (kHoldsAll) multiply(s, patch);
    }
  }

  /// The sign of h(t) + d·|l|_2, where d is the separation; −1 means separated (Eqs. 3–4). h(t) is
  /// max p·l over control points p of cell `below`, minus min q·l over control points q of the
  /// other cell, at time t. below: the side whose maximum is taken. cells: one per side, of one
  /// depth. t: a window end. candidates: per side, the control points of the cell that may attain
  /// the extreme; a superset of those that do.
  int gap_sign(int below, const std::array<Cell, 2>& cells, const IntegerAxis& axis, double t,
               const std::array<std::span<const std::uint8_t>, 2>& candidates) {
    const auto lower = static_cast<size_t>(below), upper = 1 - lower;
    auto [max, weight_of_max] = extreme(lower, true, cells[lower], axis, t, candidates[lower]);
    auto [min, weight_of_min] = extreme(upper, false, cells[upper], axis, t, candidates[upper]);
    const int depth = cells[0].depth;
    if constexpr (kHoldsAll) {
      if (is_rational_) {
        const Int n = product(max, weight_of_min), m = product(min, weight_of_max);
        return sign_of_gap(n, m, product(separation_, product(weight_of_min, weight_of_max)), axis);
      }
    }
    const int steps = blossom_steps(sides_[lower].shape) - blossom_steps(sides_[upper].shape);
    if (steps < 0) max <<= -steps * depth;
    if (steps > 0) min <<= steps * depth;
    const int most =
        std::max(blossom_steps(sides_[lower].shape), blossom_steps(sides_[upper].shape));
    return sign_of_gap(max, min, Int(separation_ << most * depth), axis);
  }

 private:
  /// Parameters as integers over 2^depth.
  using IntegerUv = std::array<std::int64_t, 2>;

  static constexpr bool kHoldsAll = std::is_same_v<Int, Integer>;

  /// Position and velocity of a control point, and its weight: 1 of a polynomial patch. Those of a
  /// cell are times 2^(depth·blossom_steps), and have weights where a patch is rational.
  using Control = std::array<Int, 7>;
  static constexpr size_t kWeight = 6;

  /// A height times a weight, and the weight.
  struct Height {
    Int value, weight;
  };

  /// The control points of a cell that some predicate needed.
  struct Part {
    Cell cell;
    std::array<IntegerUv, 3> corners;
    std::array<bool, kMaxControls> made;
    std::vector<Control> points;
  };
  static constexpr int kNoDepth = -1;

  struct Side {
    Shape shape;
    std::vector<Control> controls;
    /// Those asked of last, as many as a split has children. Each of them meets all of the other
    /// side's, on many axes.
    std::array<Part, 4> parts;
    size_t oldest = 0;
  };

  /// The words of a product and a sum. Measured, allocating an Integer and calling GMP takes as
  /// long as 32 operations on words.
  static std::uint64_t words_of(const Int& x) {
    if constexpr (std::is_same_v<Int, Integer>) {
      constexpr std::uint64_t kCalls = 32;
      return kCalls + mpz_size(x.get_mpz_t());
    } else {
      return sizeof(Int) / sizeof(std::uint64_t);
    }
  }
  /// The control points of a rational patch, homogeneous: of weights, a multiple that is whole.
  void multiply(Side& s, const MovingPatch<double>& patch) {
    if (!patch.is_rational()) return;
    int unit = parts_of(patch.weights[0]).exponent;
    for (const double w : patch.weights) unit = std::min(unit, parts_of(w).exponent);
    for (size_t i = 0; i < patch.weights.size(); ++i) {
      const Int weight = integer_in<Int>(parts_of(patch.weights[i]), unit);
      for (Int& x : s.controls[i]) x *= weight;
    }
  }

  /// x·y of numbers that have as many words as they need.
  Int product(const Int& x, const Int& y) {
    work_ += words_of(x) * mpz_size(y.get_mpz_t());
    return Int(x * y);
  }

  /// The sign of max − min + d·|l|_2.
  int sign_of_gap(const Int& max, const Int& min, const Int& d, const IntegerAxis& axis) {
    if (separation_ == Int(0)) return max < min ? -1 : max > min ? 1 : 0;
    if (!(max < min)) return 1;
    // h + d·|l|_2 with h < 0 has the sign of d²·|l|² − h². The squares have twice the bits, of
    // which d² leaves as many as |l|² takes: |d·l| < 2^bits_needed for all that is asked.
    const Int h = min - max;
    long norm_squared = 0;
    for (const std::int64_t x : axis.l) norm_squared += x * x;
    work_ += 4 * words_of(h);
    return sgn(d * d * norm_squared - h * h);
  }

  bool is_beyond(const Height& a, const Height& b, bool above) {
    if constexpr (kHoldsAll) {
      if (is_rational_) {
        const Int left = product(a.value, b.weight), right = product(b.value, a.weight);
        return above ? left > right : left < right;
      }
    }
    return above ? a.value > b.value : a.value < b.value;
  }

  /// x·y, and one addition, as which it counts.
  Int times(const Int& x, std::int64_t y) {
    work_ += words_of(x);
    return Int(x * static_cast<long>(y));
  }

  static Part& part_of(Side& side, const Cell& cell) {
    for (Part& part : side.parts) {
      if (part.cell == cell) return part;
    }
    Part& part = side.parts[side.oldest];
    side.oldest = (side.oldest + 1) % side.parts.size();
    part.cell = cell;
    part.made.fill(false);
    const std::array<Uv<double>, 3> at = cell.corners(side.shape);
    for (size_t c = 0; c < 3; ++c) {
      for (size_t k = 0; k < 2; ++k) {
        part.corners[c][k] = static_cast<std::int64_t>(std::ldexp(at[c][k], cell.depth));
      }
    }
    return part;
  }

  const Control& point(const Side& side, Part& part, int i, int j) {
    const auto at = static_cast<size_t>(side.shape.index(i, j));
    Control& out = part.points[at];
    if (part.made[at]) return out;
    part.made[at] = true;
    const size_t numbers = is_rational_ ? kWeight + 1 : kWeight;
    for (size_t k = 0; k < numbers; ++k) out[k] = number(side, k, part, i, j);
    return out;
  }

  Height extreme(size_t which, bool maximum, const Cell& cell, const IntegerAxis& axis, double t,
                 std::span<const std::uint8_t> candidates) {
    const DoubleParts parts = parts_of(t);
    CCDFUZZ_ASSERT(parts.mantissa == 0 || parts.exponent >= units_.time);
    const std::int64_t time =
        parts.mantissa == 0 ? 0 : parts.mantissa << (parts.exponent - units_.time);
    Side& side = sides_[which];
    Part& part = part_of(side, cell);
    Height best{Int(0), Int(1)};
    bool any = false;
    const Shape& shape = side.shape;
    for (int i = 0; i <= shape.n; ++i) {
      for (int j = 0; j <= shape.last_column(i); ++j) {
        if (candidates[static_cast<size_t>(shape.index(i, j))] == 0) continue;
        const Control& p = point(side, part, i, j);
        Height height{Int(0), p[kWeight]};
        for (size_t k = 0; k < 3; ++k) {
          height.value += times(p[k] + times(p[k + 3], time), axis.l[k]);
        }
        if (!any || is_beyond(height, best, maximum)) best = height;
        any = true;
      }
    }
    CCDFUZZ_ASSERT(any);
    return best;
  }

  /// Number k of control point (i, j) of the cell. It is the patch's blossom at i corners of the u
  /// end, j of the v end and the origin for the rest. The parameters are homogeneous: weights of
  /// sum 2^depth.
  Int number(const Side& side, size_t k, const Part& part, int i, int j) {
    const std::array<IntegerUv, 3>& corners = part.corners;
    const std::int64_t one = std::int64_t{1} << part.cell.depth;
    for (size_t a = 0; a < side.controls.size(); ++a) net_[a] = side.controls[a][k];
    blossom_in_place<Int>(
        side.shape, net_,
        [&](const Int& p, const Int& q, int step, bool in_v) {
          const std::int64_t s = corners[step < (in_v ? j : i) ? 1 : 0][in_v ? 1 : 0];
          return Int(times(p, one - s) + times(q, s));
        },
        [&](const Int& pw, const Int& pu, const Int& pv, int step) {
          const auto [u, v] = corners[static_cast<size_t>(corner_of_triangle(i, j, step))];
          return Int(Int(times(pw, one - u - v) + times(pv, v)) + times(pu, u));
        });
    return net_[0];
  }

  Units units_;
  bool is_rational_ = false;
  Int separation_ = Int(0);
  std::array<Side, 2> sides_;
  std::vector<Int> net_;
  std::uint64_t work_ = 0;
};

}  // namespace ccdfuzz::exact_ccd
