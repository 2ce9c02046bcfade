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
/// The three axes, each of them off by whole numbers from −most to most, without a normal. They
/// need not span space.
PlaneFrame draw_frame_near_axes(Draw& draw, std::int64_t most);

/// Coordinates on the frame's plane.
using Planar = std::array<Dyadic, 2>;

/// The tangential coordinates τ of six control points, multiples of 2^unit up to 2^(unit + 12).
/// They are a triangle that is not degenerate, with mid controls off its edge midpoints by up to an
/// eighth. They are shifted so that the point at x is the origin.
std::array<Planar, 6> tangential_part(const Barycentric& x, long unit, Draw& draw);
inline constexpr int kTangentBits = 11;

/// τ[0]·T1 + τ[1]·T2 + height·m
inline Vec3<Dyadic> point_of(const PlaneFrame& frame, const Planar& tau, const Dyadic& height) {
  return frame.tangent[0] * tau[0] + frame.tangent[1] * tau[1] + frame.out * height;
}
inline Vec3<Dyadic> point_of(const PlaneFrame& frame, const Vec3<Dyadic>& p) {
  return point_of(frame, {p[0], p[1]}, p[2]);
}

}  // namespace ccdfuzz
