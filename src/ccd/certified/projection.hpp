#pragma once

#include <array>
#include <cmath>

#include "ccd/certified/kernels.hpp"
#include "ccd/certified/normalise.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz::certified {

using Axis = std::array<double, 3>;

inline double norm1(const Axis& l) {
  return (std::abs(l[0]) + std::abs(l[1])) + std::abs(l[2]);
}

inline Axis axis_of(const AxisBatch& batch, int i) {
  return {batch.axes[0][i], batch.axes[1][i], batch.axes[2][i]};
}

/// Extent of a net's projection at one time.
struct Range {
  double min, max;
};

/// Extents of a net at both ends of a window.
struct RangePair {
  Range at_lo, at_hi;
};

/// E of DERIVATION.md ("The bound of tdibm-c"): with M ≥ Σ max|p'| + max|v'|, fl(max₁) − fl(min₂) <
/// −E in doubles implies max₁ − min₂ < 0 in exact arithmetic, for two sub-patches with at most
/// `roundings` roundings behind each control point.
class ErrorBound {
 public:
  ErrorBound() = default;
  /// magnitude, absolute: as in NormalisedQuery. Four times `absolute` are of the control points; a
  /// fifth covers what is lost by underflow in subdivision.
  ErrorBound(double magnitude, double absolute, int roundings)
      : relative_(kHalfUlp * (roundings + kFixedRoundings) * magnitude * kSlack + 5 * absolute) {}

  Lanes for_axes(const AxisBatch& batch) const {
    Lanes out;
    for (size_t i = 0; i < out.size(); ++i) {
      out[i] = for_axis(certified::norm1(axis_of(batch, static_cast<int>(i))));
    }
    return out;
  }

  double for_axis(double norm1) const { return (relative_ * norm1 + kLeastAbsolute) * kSlack; }

 private:
  static constexpr double kHalfUlp = 0x1p-53;
  /// 1 normalise + 3 dot product + 1 product with t + 1 sum + 1 difference of the two extents + 1
  /// where the bound is added to that difference.
  static constexpr int kFixedRoundings = 8;
  /// (1+u)^k − 1 ≤ k·u·(1 + k·u) with k < 2^11, and the few roundings of this expression itself.
  static constexpr double kSlack = 1 + 0x1p-20;

  double relative_ = 0;
};

/// One lane of a batch.
inline RangePair lane(const RangeBatch& ranges, int i) {
  return {{ranges.min_lo[i], ranges.max_lo[i]}, {ranges.min_hi[i], ranges.max_hi[i]}};
}

}  // namespace ccdfuzz::certified
