#pragma once

#include "generators/draw/draw.hpp"
#include "generators/quadratic.hpp"

namespace ccdfuzz {

/// A plane and a direction out of it, of integers up to kFrameBound.
struct PlaneFrame {
  std::array<Vec3<Dyadic>, 2> tangent;
  Vec3<Dyadic> out;
  Vec3<Dyadic> normal;  ///< tangent[0] × tangent[1]; normal·out > 0
};
inline constexpr int kFrameBound = 31;

PlaneFrame random_frame(Draw& draw);
/// One whose normal has a whole number as its length: its tangents are sums of two axes of a frame
/// at right angles (whole_frame.hpp).
PlaneFrame whole_normal_frame(Draw& draw);

/// Coordinates on the frame's plane.
using Planar = std::array<Dyadic, 2>;

/// The tangential coordinates τ of six control points, multiples of 2^unit up to 2^(unit + 12).
/// They are a triangle that is not degenerate, with mid controls off its edge midpoints by up to an
/// eighth. They are shifted so that the mean under the weights, Σ β τ, is zero.
std::array<Planar, 6> tangential_part(const std::array<Dyadic, 6>& weights, long unit, Draw& draw);
inline constexpr int kTangentBits = 11;

/// τ[0]·T1 + τ[1]·T2 + height·m
inline Vec3<Dyadic> point_of(const PlaneFrame& frame, const Planar& tau, const Dyadic& height) {
  return frame.tangent[0] * tau[0] + frame.tangent[1] * tau[1] + frame.out * height;
}

}  // namespace ccdfuzz
