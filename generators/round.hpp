#pragma once

#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"
#include "generators/whole_frame.hpp"

namespace ccdfuzz {

/// A patch that touches the plane z = 0 at the origin, from z ≤ 0 or from z ≥ 0.
struct RoundSide {
  Shape shape;
  std::vector<Whole> points;
  std::vector<double> weights;
  Uv<Rational> at;  ///< the origin's parameters
};

/// A quarter of a circle of radius kRadius about the origin, from its first control point to its
/// third. At p it is the first times (1 − p²)/(1 + p²) and the third times 2p/(1 + p²).
struct QuarterCircle {
  static constexpr std::int64_t kRadius = 5;
  static constexpr std::array<double, 3> kWeights = {1, 1, 2};

  std::array<std::array<std::int64_t, 2>, 3> points;
  int at;  ///< 1/at is where it is (kRadius, 0)
};
inline constexpr std::array<QuarterCircle, 2> kQuarterCircles = {
    {{{{{3, -4}, {7, -1}, {4, 3}}}, 2}, {{{{4, -3}, {7, 1}, {3, 4}}}, 3}}};

/// What is revolved: points and weights of a curve in the half-plane of distance from the axis and
/// height along it. At height 0 it has this distance, at the parameter `at`.
struct Profile {
  std::vector<std::array<std::int64_t, 2>> points;
  std::vector<double> weights;
  std::int64_t distance;
  Rational at;
  std::int64_t ring = 0;  ///< the distance from the axis of a circle's centre
  bool slants = false;    ///< at height 0 the way out is (4, −3), not (1, 0)
};

/// A circle whose centre is at this distance from the axis: that of a sphere at 0. Its radius is
/// kRadius times this.
Profile circular_profile(std::int64_t ring, std::int64_t radius, Draw& draw);
/// A line from below height 0 to above: of a cylinder, or of a cone if it slants.
Profile straight_profile(bool slants, Draw& draw);

/// The surface, at z ≤ 0. Its lengths are kPerProfile times those of the profile. The axis has the
/// direction of y, and goes through x = 0, z = −kPerProfile·distance unless the profile slants.
RoundSide revolve(const Profile& profile, const QuarterCircle& quarter);
inline constexpr std::int64_t kPerProfile = 25;

/// Two bodies of revolution, or one and a triangle (FF) or a point (VF), that first meet at t*.
/// They are parts of spheres, cylinders, cones and the outsides of tori: rational patches of
/// weights 1 and 2 and their products, which are these surfaces exactly. Where and when they meet
/// is no search's word: one is below a plane and the other above, and each moves with its side of
/// it. Positions and velocities are whole numbers times a power of two, t* is a multiple of 1/8,
/// and t_max is t* to twice as much. The truth is the witness, whose parameters are fractions, and
/// the plane. apart: they meet at a separation > 0, which the query has and which is between them.
Case draw_round_case(ContactClass contact, bool apart, Draw& draw);

}  // namespace ccdfuzz
