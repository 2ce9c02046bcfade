#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ccdfuzz::certified {

using Axis = std::array<double, 3>;

inline double norm1(const Axis& l) {
  return (std::abs(l[0]) + std::abs(l[1])) + std::abs(l[2]);
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
  /// magnitude, absolute: as in NormalisedQuery.
  ErrorBound(double magnitude, double absolute, int roundings)
      : relative_(kHalfUlp * (roundings + kFixedRoundings) * magnitude * kSlack + 4 * absolute +
                  kSubdivisionUnderflows * kEta) {}

  double for_axis(double norm1) const {
    return (relative_ * norm1 + kProductUnderflows * kEta) * kSlack;
  }

 private:
  static constexpr double kHalfUlp = 0x1p-53;
  static constexpr double kEta = 0x1p-1074;
  /// 1 normalise + 3 dot product + 1 product with t + 1 sum + 1 difference of the two extents + 1
  /// where the bound is added to that difference.
  static constexpr int kFixedRoundings = 8;
  /// (1+u)^k − 1 ≤ k·u·(1 + k·u) with k < 2^11, and the few roundings of this expression itself.
  static constexpr double kSlack = 1 + 0x1p-20;
  /// Halving loses ≤ η/2 a step; depth ≤ 50, ≤ 16 steps each, positions and velocities, two sides.
  static constexpr double kSubdivisionUnderflows = 2048;
  /// Seven products a side, η/2 each.
  static constexpr double kProductUnderflows = 16;

  double relative_ = 0;
};

/// Four control points at once; Eigen maps them to what the target's vector unit has.
using Lanes = Eigen::Array4d;

inline Eigen::Map<const Lanes> load(const double* x) {
  return Eigen::Map<const Lanes>(x);
}

/// Running extents at two times.
class Extents {
 public:
  void add(const Lanes& a, const Lanes& b, double t0, double t1) {
    const Lanes x0 = a * t0 + b, x1 = a * t1 + b;
    min0_ = min0_.min(x0);
    max0_ = max0_.max(x0);
    min1_ = min1_.min(x1);
    max1_ = max1_.max(x1);
  }
  RangePair result() const {
    return {{min0_.minCoeff(), max0_.maxCoeff()}, {min1_.minCoeff(), max1_.maxCoeff()}};
  }

 private:
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  Lanes min0_ = Lanes::Constant(kInf), min1_ = min0_;
  Lanes max0_ = Lanes::Constant(-kInf), max1_ = max0_;
};

/// Extents on axis l at times t0 and t1 of a net of `width` (a multiple of 4) control points.
/// Each value is ((l₀x + l₁y) + l₂z) for position and velocity, then fl(a·t) + b.
inline RangePair project(const double* net, int width, const Axis& l, double t0, double t1) {
  Extents extents;
  const auto along = [&](const double* x) -> Lanes {
    return (l[0] * load(x) + l[1] * load(x + width)) + l[2] * load(x + 2 * width);
  };
  for (int i = 0; i < width; i += 4) {
    extents.add(along(net + 3 * width + i), along(net + i), t0, t1);
  }
  return extents.result();
}

/// The same on coordinate axis k, where no product with the axis is needed.
inline RangePair project_coordinate(const double* net, int width, int k, double t0, double t1) {
  Extents extents;
  for (int i = 0; i < width; i += 4) {
    extents.add(load(net + (k + 3) * width + i), load(net + k * width + i), t0, t1);
  }
  return extents.result();
}

/// Extent at time t and the slope of the control point that attains each end.
struct SlopedRange {
  double min, max, slope_of_min, slope_of_max;
};

inline SlopedRange project_with_slopes(const double* net, int width, const Axis& l, double t) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  SlopedRange r{inf, -inf, 0, 0};
  const double *p = net, *v = net + 3 * width;
  for (int i = 0; i < width; ++i) {
    const double b = (l[0] * p[i] + l[1] * p[i + width]) + l[2] * p[i + 2 * width];
    const double a = (l[0] * v[i] + l[1] * v[i + width]) + l[2] * v[i + 2 * width];
    const double x = a * t + b;
    if (x < r.min) r.min = x, r.slope_of_min = a;
    if (x > r.max) r.max = x, r.slope_of_max = a;
  }
  return r;
}

}  // namespace ccdfuzz::certified
