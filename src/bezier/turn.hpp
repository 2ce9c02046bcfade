#pragma once

#include <optional>
#include <vector>

#include "base/result.hpp"
#include "numeric/vec3.hpp"

namespace ccdfuzz {

/// How a body turns. At time t a point p of it is at centre + R·(p − centre), and moves on by its
/// velocity. R is the rotation of q(t) = (1 − t)·from + t·to, whose length does not matter:
/// - of four numbers w, x, y, z the rotation of a quaternion, p ↦ q p q* / |q|²;
/// - of two numbers the rotation about the z axis by an angle of such a cosine and sine, times |q|.
/// So engines interpolate that normalise a linear interpolation. They differ: the angle of a
/// quaternion is half of that of its rotation.
/// Or it is a spin, of a constant angular velocity w: R is exp([w·t]×), the rotation about w by
/// |w|·t radians.
struct BodyTurn {
  std::vector<double> from, to;
  Vec3<double> centre{0, 0, 0};
  std::vector<double> spin = {};  ///< w; from and to are empty then, and it is empty otherwise

  bool is_quaternion() const { return from.size() == 4; }
  bool is_spin() const { return !spin.empty(); }

  friend bool operator==(const BodyTurn&, const BodyTurn&) = default;
};

/// A spin is at most so many radians in [0, 1], a little more than a whole turn: series of few
/// terms enclose it then.
inline constexpr double kFastestSpin = 8;

/// What is wrong with a turn: numbers that are not four or two, or not finite; or from·to ≤ 0,
/// without which no q(t) of [0, 1] is 0. A spin has three, and is no faster than kFastestSpin. It
/// says in which field.
std::optional<InputError> fault_of(const BodyTurn& turn);

}  // namespace ccdfuzz
