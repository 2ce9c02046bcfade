#pragma once

#include "case/case.hpp"
#include "certify/checker/work.hpp"

namespace ccdfuzz {

/// The root of x ≥ 0, rounded up by less than 2^-bits of what it is, or exact.
Rational root_above(const Rational& x, Work& work, unsigned long bits = 64);

/// A point that is known but for a small error.
struct MovedPoint {
  Vec3<Rational> point;
  Rational error = 0;  ///< it is no farther away than this
};

/// The point of a body at time t that stands at p before it turns and moves. That of a body that
/// spins is enclosed. So is that of one that turns by cosine and sine, where |q(t)| is no rational.
/// A body in the plane z = 0 that turns in it stays there exactly.
MovedPoint moved_point(const MovingPatch<double>& body, const Vec3<Rational>& p, const Rational& t,
                       Work& work);

/// Certificate N: checks that two bodies are farther apart than the reach (check_bodies.hpp) at
/// every t in the closed [0, until]. Requires a valid query of bodies. Errors: what is wrong,
/// naming the field; more than kMostWork.
///
/// Proof. Each point's height above the plane, times D ≥ 0, is G·D + H: D is |q|² of a quaternion,
/// |q| of cosine and sine, or 1. All are polynomials in t but |q|, and D > 0 in [0, 1]. What is
/// checked is that no Bernstein coefficient of G·D + H is negative between two times. |q| is a
/// convex function of t: above it is its chord, and below it is q·u for each |u| ≤ 1. G·D + H is
/// linear in D, so that it is ≥ 0 at |q| if it is so for both of these. So the points of patch 1
/// are at most at the offset, and those of patch 2 at least at the offset + gap. They are gap/|n|
/// apart, and |n| is largest at an end, as n changes linearly.
///
/// The quaternion q of a spin is no polynomial. From its value at the piece's start (spin.hpp) on
/// it turns about one axis, as a complex number exp(i|v|s) does. So its series up to s² leaves out
/// at most |v|³/6. With r the product of both series, |q p q* − r p r*| is no larger than
/// |q − r|·(2 + |q − r|)·|p|. A height is off by no more than |n| times that, and is to be > 0 by
/// so much.
Result<void> check_body_planes(const Query& query, const BodyPlanes& clearance);

/// The same of one plane, from its time until a later one.
Result<void> check_body_plane(const Query& query, const BodyPlanes::Plane& plane,
                              const Rational& until);

}  // namespace ccdfuzz
