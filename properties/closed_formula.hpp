#pragma once

#include <array>
#include <optional>

#include "case/query.hpp"
#include "generators/draw/draw.hpp"
#include "numeric/exact_scalars.hpp"

namespace ccdfuzz {

/// Two moving surfaces, of which patches are pieces: spheres, cylinders, a torus, a plane, a point.
/// Each is all that is at one distance from its core: from its centre, its axis or itself. For a
/// torus and a plane the core is the point of the torus's ring that is nearest to the plane. So the
/// surfaces come together as their cores come to one distance. That is a polynomial of degree 2 in
/// time, which is made of centres, axes, radii and velocities, and of no contact.
struct ClosedFormula {
  Query query;  ///< t_max is how long the formula is asked
  /// The way from core to core at t, at right angles to both, is (way + t·rate)/scale.
  Vec3<Rational> way, rate;
  Rational scale;
  Rational reach;  ///< both radii and the query's separation
  Rational slack;  ///< more than the boxes of a search whose precision is 2^-14 are large
  /// The surfaces first touch after times[0], and by times[1], and there both patches do. nullopt:
  /// they do not touch.
  std::optional<std::array<Rational, 2>> times;

  /// Whether the surfaces are nearer to touching than this at t.
  bool is_within(const Rational& distance, const Rational& t) const;
};

/// Lengths and velocities are whole numbers times a power of two. Patches are an eighth of a sphere
/// and more, or such parts of other surfaces. Discarded: surfaces that touch at t = 0, or elsewhere
/// than inside the patches. separation: they are to come as near as that. of_point: a cylinder that
/// meets a point head-on, which some methods miss.
ClosedFormula draw_closed_formula(bool separation, bool of_point, Draw& draw);

}  // namespace ccdfuzz
