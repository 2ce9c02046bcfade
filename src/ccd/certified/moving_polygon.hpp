#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "case/query.hpp"
#include "ccd/certified/time_polynomial.hpp"

namespace ccdfuzz::certified {

/// A moving polygon, whose corners are the differences of control points, about the origin: both
/// patches touch where the origin is in it. Law L1: they touch iff the determinant is 0 and the
/// first of these that applies holds. (a) In a component of which some cross is not 0, no two
/// crosses have opposite signs. (b) In a coordinate that is not 0 at some corner, not all corners
/// are on one side of 0. (c) All corners are 0. A triangle, of equal corners where there are fewer,
/// or a parallelogram. Law L6: all integers fit.
class MovingPolygon {
 public:
  static constexpr std::size_t kMostCorners = 4;

  /// False where the numbers do not fit (Law L7).
  bool begin(const Query& query);

  std::size_t corners() const { return corners_; }
  /// Coordinate k of a corner.
  const TimePolynomial& corner(std::size_t i, std::size_t k) const { return corner_[i][k]; }
  /// Component k of corner i × corner j, where j follows i: the first follows the last. Law L1:
  /// there is no contact where two of one component have opposite signs.
  const TimePolynomial& cross(std::size_t i, std::size_t k) {
    if (!std::exchange(has_cross_[i][k], true)) {
      const std::size_t j = (i + 1) % corners_, y = (k + 1) % 3, z = (k + 2) % 3;
      cross_[i][k] = corner_[i][y] * corner_[j][z] - corner_[i][z] * corner_[j][y];
    }
    return cross_[i][k];
  }
  /// The determinant of three corners. Law L1: it is 0 wherever the patches touch.
  TimePolynomial determinant() {
    return corner(0, 0) * cross(1, 0) + corner(0, 1) * cross(1, 1) + corner(0, 2) * cross(1, 2);
  }

 private:
  bool make_coordinate(const Query& query, std::size_t k);

  std::size_t corners_ = 0;
  std::array<std::array<int, 2>, kMostCorners> places_{};
  std::array<std::array<TimePolynomial, 3>, kMostCorners> corner_;
  std::array<std::array<TimePolynomial, 3>, kMostCorners> cross_;
  std::array<std::array<bool, 3>, kMostCorners> has_cross_{};
};

}  // namespace ccdfuzz::certified
