#pragma once

#include <array>
#include <span>
#include <vector>

#include "bezier/cell.hpp"
#include "ccd/rational/axis.hpp"
#include "ccd/rational/units.hpp"
#include "numeric/double_parts.hpp"
#include "numeric/rational.hpp"
#include "numeric/verify.hpp"
#include "numeric/wide_int.hpp"

namespace ccdfuzz::exact_ccd {

/// parts·2^-unit as an integer. Requires parts.exponent ≥ unit or parts = 0.
template <class Int>
Int integer_in(const DoubleParts& parts, int unit) {
  if (parts.mantissa == 0) return Int(0);
  return Int(parts.mantissa) << (parts.exponent - unit);
}
template <>
inline Integer integer_in<Integer>(const DoubleParts& parts, int unit) {
  Integer out(static_cast<long>(parts.mantissa));
  if (parts.mantissa != 0) out <<= static_cast<mp_bitcnt_t>(parts.exponent - unit);
  return out;
}

/// One query in integers of type Int (a WideInt, or Integer for any size), and the predicate that
/// everything stands on: the exact sign of the gap of two cells along an axis at a time.
/// Int must hold Units::bits_needed bits for every predicate asked.
template <class Int>
class ExactScene {
 public:
  /// Allocates only when the query has more control points than any before.
  void load(const Query& query, const Units& units) {
    units_ = units;
    for (size_t side = 0; side < 2; ++side) {
      const MovingPatch<double>& patch = query.patches[side];
      Side& s = sides_[side];
      s.shape = patch.shape;
      const size_t count = patch.positions.size();
      s.position.resize(count);
      s.velocity.resize(count);
      if (s.projected.size() < count) s.projected.resize(count);
      if (net_.size() < count) net_.resize(count);
      for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < 3; ++k) {
          const auto at = static_cast<Eigen::Index>(k);
          s.position[i][k] = integer_in<Int>(parts_of(patch.positions[i][at]), units.length);
          s.velocity[i][k] =
              integer_in<Int>(parts_of(patch.velocities[i][at]), units.length - units.time);
        }
      }
    }
  }

  /// The sign of h(t) = max over control points p of cell `below` of p·l − min over control points
  /// q of the other cell of q·l, at time t; −1 means separated (Eqs. 3–4).
  /// below: the side whose maximum is taken. cells: one per side, of one depth. t: a window end.
  /// candidates: per side, the control points of the cell that may attain the extreme; a superset
  /// of those that do.
  int gap_sign(int below, const std::array<Cell, 2>& cells, const Axis& axis, double t,
               const std::array<std::span<const std::uint8_t>, 2>& candidates) {
    const auto lower = static_cast<size_t>(below), upper = 1 - lower;
    Int max = extreme(lower, true, cells[lower], axis, t, candidates[lower]);
    Int min = extreme(upper, false, cells[upper], axis, t, candidates[upper]);
    const int depth = cells[0].depth;
    const int steps = blossom_steps(sides_[lower].shape) - blossom_steps(sides_[upper].shape);
    if (steps < 0) max = shift(max, -steps * depth);
    if (steps > 0) min = shift(min, steps * depth);
    return max < min ? -1 : max > min ? 1 : 0;
  }

 private:
  using Vector = std::array<Int, 3>;
  /// Parameters as integers over 2^depth.
  using IntegerUv = std::array<std::int64_t, 2>;

  struct Side {
    Shape shape;
    std::vector<Vector> position, velocity;
    std::vector<Int> projected;
  };

  static Int shift(const Int& x, int by) {
    if constexpr (std::is_same_v<Int, Integer>) {
      return Int(x << static_cast<mp_bitcnt_t>(by));
    } else {
      return x << by;
    }
  }
  static Int times(const Int& x, std::int64_t y) {
    if constexpr (std::is_same_v<Int, Integer>) {
      return Int(x * static_cast<long>(y));
    } else {
      return x * y;
    }
  }

  /// The projections of all control points of the whole patch at time t.
  void project(Side& side, const Axis& axis, double t) {
    const DoubleParts parts = parts_of(t);
    CCDFUZZ_ASSERT(parts.mantissa == 0 || parts.exponent >= units_.time);
    const std::int64_t time =
        parts.mantissa == 0 ? 0 : parts.mantissa << (parts.exponent - units_.time);
    for (size_t i = 0; i < side.position.size(); ++i) {
      Int sum(0);
      for (size_t k = 0; k < 3; ++k) {
        sum += times(side.position[i][k] + times(side.velocity[i][k], time), axis.l[k]);
      }
      side.projected[i] = sum;
    }
  }

  Int extreme(size_t which, bool maximum, const Cell& cell, const Axis& axis, double t,
              std::span<const std::uint8_t> candidates) {
    Side& side = sides_[which];
    project(side, axis, t);
    const std::array<Uv<double>, 3> at = cell.corners(side.shape);
    std::array<IntegerUv, 3> corners;
    for (size_t c = 0; c < 3; ++c) {
      for (size_t k = 0; k < 2; ++k) {
        corners[c][k] = static_cast<std::int64_t>(std::ldexp(at[c][k], cell.depth));
      }
    }
    Int best(0);
    bool any = false;
    const Shape& shape = side.shape;
    const int rows = shape.kind == ShapeKind::kPoint ? 0 : shape.n;
    for (int i = 0; i <= rows; ++i) {
      const int columns = shape.kind == ShapeKind::kTriangle ? shape.n - i : shape.m;
      for (int j = 0; j <= columns; ++j) {
        if (candidates[static_cast<size_t>(shape.index(i, j))] == 0) continue;
        const Int value = control(side, corners, cell.depth, i, j);
        if (!any || (maximum ? value > best : value < best)) best = value;
        any = true;
      }
    }
    CCDFUZZ_ASSERT(any);
    return best;
  }

  /// 2^(depth·blossom_steps) times control point (i, j) of the cell, projected: the blossom of the
  /// projections at i corners of the u end, j of the v end and the origin for the rest, with
  /// homogeneous parameters (weights of sum 2^depth).
  Int control(const Side& side, const std::array<IntegerUv, 3>& corners, int depth, int i, int j) {
    const std::int64_t one = std::int64_t{1} << depth;
    const Shape& shape = side.shape;
    std::copy(side.projected.begin(), side.projected.begin() + shape.control_count(), net_.begin());
    const auto lerp = [&](const Int& p, const Int& q, std::int64_t s) {
      return Int(times(p, one - s) + times(q, s));
    };
    switch (shape.kind) {
      case ShapeKind::kPoint:
        break;
      case ShapeKind::kCurve:
        for (int left = shape.n, step = 0; left > 0; --left, ++step) {
          const std::int64_t u = corners[step < i ? 1 : 0][0];
          for (int a = 0; a < left; ++a) net(a) = lerp(net(a), net(a + 1), u);
        }
        break;
      case ShapeKind::kTriangle:
        for (int left = shape.n, step = 0; left > 0; --left, ++step) {
          const Shape from = Shape::triangle(left), to = Shape::triangle(left - 1);
          const auto [u, v] = corners[step < i ? 1 : step < i + j ? 2 : 0];
          for (int a = 0; a < left; ++a) {
            for (int b = 0; b < left - a; ++b) {
              const Int value = Int(Int(times(net(from.index(a, b)), one - u - v) +
                                        times(net(from.index(a, b + 1)), v)) +
                                    times(net(from.index(a + 1, b)), u));
              net(to.index(a, b)) = value;  // to.index ≤ from.index of all later reads
            }
          }
        }
        break;
      case ShapeKind::kTensor:
        for (int a = 0; a <= shape.n; ++a) {
          const int row = shape.index(a, 0);
          for (int left = shape.m, step = 0; left > 0; --left, ++step) {
            const std::int64_t v = corners[step < j ? 1 : 0][1];
            for (int b = 0; b < left; ++b) net(row + b) = lerp(net(row + b), net(row + b + 1), v);
          }
        }
        for (int left = shape.n, step = 0; left > 0; --left, ++step) {
          const std::int64_t u = corners[step < i ? 1 : 0][0];
          for (int a = 0; a < left; ++a) {
            net(shape.index(a, 0)) = lerp(net(shape.index(a, 0)), net(shape.index(a + 1, 0)), u);
          }
        }
        break;
    }
    return net(0);
  }

  Int& net(int i) { return net_[static_cast<size_t>(i)]; }

  Units units_;
  std::array<Side, 2> sides_;
  std::vector<Int> net_;
};

}  // namespace ccdfuzz::exact_ccd
