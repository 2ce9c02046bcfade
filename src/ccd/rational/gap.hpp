#pragma once

#include <array>
#include <cstdint>

#include "ccd/rational/axis.hpp"
#include "ccd/rational/cell_points.hpp"
#include "ccd/rational/exact_scene.hpp"
#include "ccd/rational/units.hpp"

namespace ccdfuzz::exact_ccd {

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
/// where the error bound allows, integers where it does not.
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

  /// Projects the selected cells on an axis.
  void project(const IntegerAxis& axis);
  Extremes extremes(double t) const;
  /// |gap − exact gap·2^length_shift| ≤ error(), at any t in [0, 1].
  double error() const { return error_; }
  /// d gap/dt of the lines that attain it at t.
  double slope(int below, double t) const;

  /// The exact sign of h(t). `at` is extremes(t). t must be a scaled window end.
  int sign(int below, double t, const Extremes& at) {
    const double gap = at.gap(below);
    if (gap < -error_ || gap > error_) return gap < 0 ? -1 : 1;
    return exact_sign(below, t, at);
  }

  /// The normalised scene is the query's, its lengths times 2^length_shift.
  int length_shift() const { return length_shift_; }

  /// Operations on 64-bit words since begin(), where doubles did not decide.
  std::uint64_t exact_work() const { return scene_.work() - work_before_; }

 private:
  int exact_sign(int below, double t, const Extremes& at);
  /// The height of control point i of the selected cell, on the axis that it is projected on.
  double height(size_t side, int i, double t) const {
    const auto k = static_cast<size_t>(i);
    return slopes_[side][k] * t + intercepts_[side][k];
  }

  const Query* query_ = nullptr;
  Units units_;
  Points<double> positions_, velocities_, starts_;  ///< one side's, normalised; for begin() alone
  std::array<CellPointsCache, 2> cache_;
  std::array<CellPoints, 2> families_;
  std::array<std::array<Cell, 4>, 2> parts_;

  std::array<Cell, 2> cells_;
  std::array<CellPoints, 2> selected_;
  IntegerAxis axis_;
  using Values = std::array<double, kMaxControls>;
  std::array<Values, 2> slopes_, intercepts_;
  int length_shift_ = 0;
  double error_per_norm_ = 0, error_ = 0;
  double separation_ = 0, on_axis_ = 0;  ///< normalised; times |l|_2

  ExactScene scene_;  ///< of the query, once is_loaded_
  bool is_loaded_ = false;
  std::uint64_t work_before_ = 0;
};

}  // namespace ccdfuzz::exact_ccd
