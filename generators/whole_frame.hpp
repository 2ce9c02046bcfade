#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "generators/draw/draw.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

/// Whole numbers: points and directions before they are scaled.
using Whole = std::array<std::int64_t, 3>;

inline Whole operator+(const Whole& a, const Whole& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Whole operator*(std::int64_t k, const Whole& a) {
  return {k * a[0], k * a[1], k * a[2]};
}
inline Whole any_whole(Draw& draw, std::int64_t most) {
  Whole out{};
  for (std::int64_t& x : out) x = draw.integer(-most, most);
  return out;
}

/// p·2^exponent
inline Vec3<double> times_power(const Whole& p, int exponent) {
  Vec3<double> x;
  for (int k = 0; k < 3; ++k) {
    x[k] = std::ldexp(static_cast<double>(p[static_cast<std::size_t>(k)]), exponent);
  }
  return x;
}

/// Three directions of the frame's coordinates. `length`: that of each, where they are at right
/// angles and of one length; else 0.
struct WholeFrame {
  std::array<Whole, 3> axes;
  std::int64_t length = 0;

  Whole operator()(const Whole& p) const {
    return p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
  }
  /// At right angles to the first two, towards the third.
  Whole normal() const {
    const Whole n = length != 0 ? axes[2] : cross(axes[0], axes[1]);
    return dot(n, axes[2]) < 0 ? -1 * n : n;
  }
};

/// Whole orthogonal matrices times the length of their rows.
inline constexpr std::array<WholeFrame, 5> kRightAngles = {
    WholeFrame{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1},
    WholeFrame{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}, 5},
    WholeFrame{{{{2, -1, 2}, {2, 2, -1}, {-1, 2, 2}}}, 3},
    WholeFrame{{{{2, 3, 6}, {3, -6, 2}, {6, 2, -3}}}, 7},
    WholeFrame{{{{1, 4, 8}, {8, -4, 1}, {4, 7, -4}}}, 9}};

/// One of these, its axes in any order and of any sign.
inline WholeFrame draw_right_angles(Draw& draw) {
  WholeFrame frame = draw.coin() ? kRightAngles[0] : draw.pick(kRightAngles);
  std::rotate(frame.axes.begin(), frame.axes.begin() + static_cast<long>(draw.below(3)),
              frame.axes.end());
  if (draw.coin()) std::swap(frame.axes[0], frame.axes[1]);
  for (Whole& axis : frame.axes) axis = draw.coin() ? -1 * axis : axis;
  return frame;
}

}  // namespace ccdfuzz
