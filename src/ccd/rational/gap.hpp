#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "ccd/rational/axis.hpp"
#include "ccd/rational/cell_points.hpp"
#include "ccd/rational/exact_scene.hpp"
#include "ccd/rational/units.hpp"

namespace ccdfuzz::exact_ccd {

/// How often each tier decided a predicate. Tests assert that each is reached.
struct TierCounts {
  std::uint64_t filter = 0;  ///< double arithmetic with its error bound
  std::uint64_t int128 = 0;
  std::uint64_t int256 = 0;
  std::uint64_t int512 = 0;
  std::uint64_t gmp = 0;

  friend bool operator==(const TierCounts&, const TierCounts&) = default;
};

/// Largest and smallest projections of both cells at one time, in double precision.
struct Extremes {
  std::array<double, 2> max{}, min{};
  double separation = 0;  ///< d·|l|_2

  /// The gap along the axis if `below` is the lower side, with the separation.
  double gap(int below) const {
    return (max[static_cast<size_t>(below)] - min[static_cast<size_t>(1 - below)]) + separation;
  }
};

/// The gap function h(t) = max_{below} − min_{above} of two cells along an axis: convex and
/// piecewise linear in t, negative iff the axis separates. Its sign is exact: double arithmetic
/// where the error bound allows, the narrowest sufficient integers where it does not.
///
/// The doubles are those of a normalised scene. Positions and velocities are relative to control
/// point 0 of patch 1, lengths are scaled by a power of two to magnitude ≤ 2, times to [0, 1].
/// Neither changes the sign of a gap. All times in this interface are scaled: t·2^-horizon.
class Gap {
 public:
  void begin(const Query& query);

  const Units& units() const { return units_; }
  double scaled(double t) const { return std::ldexp(t, -units_.horizon); }
  double unscaled(double t) const { return std::ldexp(t, units_.horizon); }

  /// Makes the control points of the parts that select() will name.
  void prepare(int side, std::span<const Cell> parts);
  void select(int part_a, int part_b);
  /// The control points of a prepared part.
  CellPoints points(int side, int part) const {
    return CellPointsCache::member(families_[static_cast<size_t>(side)], part);
  }

  /// Projects the selected cells on an axis with components of magnitude ≤ 2^bits.
  void project(const IntegerAxis& axis, int bits);
  Extremes extremes(double t) const;
  /// |gap − exact gap·2^length_shift| ≤ error(), at any t in [0, 1].
  double error() const { return error_; }
  /// d gap/dt of the lines that attain it at t.
  double slope(int below, double t) const;

  /// The exact sign of h(t). `at` is extremes(t). t must be a scaled window end.
  int sign(int below, double t, const Extremes& at) {
    const double gap = at.gap(below);
    if (gap < -error_ || gap > error_) {
      ++counts_.filter;
      return gap < 0 ? -1 : 1;
    }
    return exact_sign(below, t, at);
  }

  /// The normalised scene is the query's, its lengths times 2^length_shift.
  int length_shift() const { return length_shift_; }

  const TierCounts& counts() const { return counts_; }
  /// Operations on 64-bit words of the exact tiers since begin().
  std::uint64_t exact_work() const { return exact_work_; }

 private:
  int exact_sign(int below, double t, const Extremes& at);
  /// The height of control point i of the selected cell, on the axis that it is projected on.
  double height(size_t side, int i, double t) const {
    const auto k = static_cast<size_t>(i);
    return slopes_[side][k] * t + intercepts_[side][k];
  }

  /// The query in integers of one size, converted on first use.
  template <class Int>
  struct Tier {
    ExactScene<Int> scene;
    bool loaded = false;

    ExactScene<Int>& of(const Query& query, const Units& units) {
      if (!loaded) scene.load(query, units);
      loaded = true;
      return scene;
    }
  };

  const Query* query_ = nullptr;
  bool is_rational_ = false;
  Units units_;
  Points<double> positions_, velocities_, starts_;  ///< one side's, normalised; for begin() alone
  std::array<CellPointsCache, 2> cache_;
  std::array<CellPoints, 2> families_;
  std::array<std::array<Cell, 4>, 2> parts_;

  std::array<Cell, 2> cells_;
  std::array<CellPoints, 2> selected_;
  IntegerAxis axis_;
  int axis_bits_ = 0;
  using Values = std::array<double, padded(kMaxControls)>;
  alignas(16) std::array<Values, 2> slopes_, intercepts_;
  int length_shift_ = 0;
  double error_per_norm_ = 0, error_ = 0;
  double separation_ = 0, on_axis_ = 0;  ///< normalised; times |l|_2

  std::tuple<Tier<WideInt<128>>, Tier<WideInt<256>>, Tier<WideInt<512>>, Tier<Integer>> tiers_;
  TierCounts counts_;
  std::uint64_t exact_work_ = 0;
};

}  // namespace ccdfuzz::exact_ccd
