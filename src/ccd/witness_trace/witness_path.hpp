#pragma once

#include <array>
#include <cstdint>

#include "bezier/cell.hpp"
#include "case/case.hpp"
#include "ccd/time_interval.hpp"

namespace ccdfuzz {

/// Where an exact time t ≥ 0 lies among the doubles: lo ≤ t ≤ hi, equal if t is a double and
/// neighbours if not. So a double x is ≤ t iff x ≤ lo, ≥ t iff x ≥ hi, and every comparison below
/// is exact.
struct TimeBounds {
  double lo = 0;
  double hi = 0;

  bool within(const TimeWindow<double>& w) const { return w.lo <= lo && hi <= w.hi; }
  bool within(const SeparatedInterval<double>& s) const {
    return (s.lo < hi || (s.has_lo && s.lo == hi && lo == hi)) &&
           (lo < s.hi || (s.has_hi && s.hi == lo && lo == hi));
  }
};

/// A witness in the numbers that tracing compares with, all exact: which cells of the subdivision
/// contain it, and which times are before and after it.
class WitnessPath {
 public:
  /// Requires a witness that lies in the domains of the shapes (check_contact), t ≥ 0.
  /// Times are those of a method that divides them by 2^time_exponent.
  void assign(const std::array<Shape, 2>& shapes, const Witness& witness, int time_exponent = 0);

  /// True iff the closed cell of patch `side` contains the witness; as Cell::contains.
  bool in(int side, const Cell& cell) const;

  /// t·2^-time_exponent.
  const TimeBounds& time() const { return time_; }

 private:
  /// A number x ≥ 0: units·2^-kMaxDepth, and less than one unit more.
  struct FixedPoint {
    std::uint64_t units = 0;
    bool more = false;

    bool at_least(std::uint64_t k, int depth) const { return units >= shifted(k, depth); }
    bool at_most(std::uint64_t k, int depth) const {
      return units < shifted(k, depth) || (units == shifted(k, depth) && !more);
    }
    static std::uint64_t shifted(std::uint64_t k, int depth) {
      return k << (Cell::kMaxDepth - depth);
    }
  };

  /// Requires 0 ≤ x ≤ 2.
  static FixedPoint fixed_point(const Rational& x);

  std::array<Shape, 2> shapes_;
  /// u, v and u + v of each side.
  std::array<std::array<FixedPoint, 3>, 2> at_;
  TimeBounds time_;
};

}  // namespace ccdfuzz
