#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ccd/certified/kernels.hpp"
#include "ccd/certified/normalise.hpp"
#include "ccd/certified/provenance.hpp"
#include "numeric/ieee_arithmetic.hpp"

namespace ccdfuzz::certified {

using Axis = std::array<double, 3>;

inline Axis coordinate_axis(int k) {
  Axis l{};
  l[static_cast<size_t>(k)] = 1;
  return l;
}

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

/// E of DERIVATION.md, 3: of_rounding(l), and for_axis(l) with a separation.
/// Law C: let two sub-patches have at most `roundings` roundings behind each control point, and let
/// M be Σ max|p'| + max|v'|, summed in doubles: kSlack covers its roundings. Then, at any double t'
/// in [0, 1], fl(max₁) − fl(min₂) < −E in doubles implies max₁ − min₂ < 0 in exact arithmetic. With
/// a separation d it implies max₁ − min₂ < −d·|l|₂: no points of them are as near as d.
class HeightErrorBound {
 public:
  /// 1 normalise + 3 dot product + 1 product with t + 1 sum + 1 difference of the two extents + 1
  /// where the bound is added to that difference.
  static constexpr int kFixedRoundings = 8;
  static constexpr double kHalfUlp = 0x1p-53;

  HeightErrorBound() = default;
  /// magnitude, absolute: as in NormalisedQuery. E has `absolute` five times: four are of the
  /// control points, and one is of what underflows later. That is in subdivision, and in products
  /// with t and with weights. separation: scaled as lengths are.
  HeightErrorBound(double magnitude, double absolute, int roundings, double separation = 0)
      : relative_(kHalfUlp * (roundings + kFixedRoundings) * magnitude * kSlack + 5 * absolute),
        separation_(separation),
        made_from_(magnitude, absolute, roundings) {}

  /// Whatever an axis may need allowance for has its place here.
  double for_axis(const Axis& l) const {
    const double rounding = of_rounding(l);
    return separation_ > 0 ? rounding + separation_ * above_norm2(l) : rounding;
  }
  /// Without the separation.
  double of_rounding(const Axis& l) const {
    return (relative_ * norm1(l) + kLeastAbsolute) * kSlack;
  }

  Bounds for_axes(const AxisBatch& batch) const {
    Bounds out{{}, made_from_};
    for (int i = 0; i < kLanes; ++i) {
      const Axis l = axis_of(batch, i);
      out.on[static_cast<size_t>(i)] = for_axis(l);
#ifndef NDEBUG
      out.made_from.norms[static_cast<size_t>(i)] = norm1(l);
#endif
    }
    return out;
  }

 private:
  /// At least |l|₂. The excess covers three more roundings: of the product, of its sum with
  /// `rounding`, and of that with a gap. Half of 3 roundings come from the sum, one from x, y and
  /// z, and 3 from the root and its products: they are below 2^-50 together. A subnormal |l|₂ it
  /// may miss: then kLeastAbsolute is more than any gap.
  static double above_norm2(const Axis& l) {
    constexpr double kExcess = 1 + 0x1p-49;
    if (const double squared = (l[0] * l[0] + l[1] * l[1]) + l[2] * l[2];
        kLeastSquare <= squared && squared <= std::numeric_limits<double>::max()) {
      return std::sqrt(squared) * kExcess;
    }
    const double most = std::max({std::abs(l[0]), std::abs(l[1]), std::abs(l[2])});
    if (most == 0) return 0;
    // The largest component is scaled to 1, so a square that underflows is nothing beside it.
    const double x = l[0] / most, y = l[1] / most, z = l[2] / most;
    return std::sqrt((x * x + y * y) + z * z) * most * kExcess;
  }
  /// A square that underflows loses η/2 at most, less than 2^-100 of a sum from here on.
  static constexpr double kLeastSquare = 0x1p-960;

  /// (1+u)^k − 1 ≤ k·u·(1 + k·u) with k < 2^11, and the few roundings of this expression itself.
  static constexpr double kSlack = 1 + 0x1p-20;

  double relative_ = 0;
  double separation_ = 0;
  [[no_unique_address]] Basis made_from_;
};

}  // namespace ccdfuzz::certified
