#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "ccd/certified/time_polynomial.hpp"
#include "query/query.hpp"

namespace ccdfuzz::certified {

/// A moving polygon, whose corners are the differences of control points, about the origin: both
/// patches touch where the origin is in it. A triangle, of equal corners where there are fewer, or
/// a parallelogram.
class MovingPolygon {
 public:
  static constexpr std::size_t kMostCorners = 4;

  /// False where the numbers do not fit.
  bool begin(const Query& query);

  std::size_t corners() const { return corners_; }
  /// Coordinate k of a corner.
  const TimePolynomial& corner(std::size_t i, std::size_t k) const { return corner_[i][k]; }
  /// Component k of corner i × corner i + 1, of which the last is followed by the first.
  const TimePolynomial& cross(std::size_t i, std::size_t k) {
    if (!std::exchange(has_cross_[i][k], true)) {
      const std::size_t j = (i + 1) % corners_, y = (k + 1) % 3, z = (k + 2) % 3;
      cross_[i][k] = corner_[i][y] * corner_[j][z] - corner_[i][z] * corner_[j][y];
    }
    return cross_[i][k];
  }
  /// Of three corners.
  TimePolynomial determinant() {
    TimePolynomial sum;
    for (std::size_t k = 0; k < 3; ++k) sum = sum + corner(0, k) * cross(1, k);
    return sum;
  }

 private:
  bool make_coordinate(const Query& query, std::size_t k);

  std::size_t corners_ = 0;
  std::array<std::array<int, 2>, kMostCorners> places_{};
  std::array<std::array<TimePolynomial, 3>, kMostCorners> corner_, cross_;
  std::array<std::array<bool, 3>, kMostCorners> has_cross_{};
};

}  // namespace ccdfuzz::certified
