#pragma once

#include <optional>

#include "case/case.hpp"
#include "generators/frame.hpp"
#include "generators/shaped/features.hpp"

namespace ccdfuzz {

/// A patch in the frame of its contact, where the contact plane is z = 0.
struct ContactSide {
  Shape shape;
  Uv<Dyadic> at;          ///< parameters of the contact
  Points<Dyadic> points;  ///< control points at t*; patch 1 has z ≥ 0, patch 2 has z ≤ 0
  Points<Dyadic> rates;   ///< their velocities
};

/// Two patches of any shapes that touch at t*, in the frame of their contact.
struct ContactScene {
  Dyadic t = 1;      ///< t*
  Dyadic t_max = 1;  ///< end of a query that is to find the contact; t* ≤ t_max
  std::array<ContactSide, 2> sides;
  /// The plane z = 0, moving along, separates the patches before t*. All over both patches z has
  /// the sign said above at t*, and all of patch 1 falls faster than anything of patch 2.
  bool separated = false;
  bool touches = true;  ///< false: patch 2 was moved away, and nothing is known
};

/// Where the frame of the contact stands in space: x → 2^exponent·(frame(x) + shift + t·drift),
/// exponents by coordinate.
struct Placement {
  PlaneFrame frame;
  Vec3<Dyadic> shift = {Dyadic(), Dyadic(), Dyadic()};
  Vec3<Dyadic> drift = {Dyadic(), Dyadic(), Dyadic()};
  std::array<long, 3> exponent{};
  /// Moves each control velocity by up to so many ulps, and its path so that it is where it was at
  /// t*. Patches that owe something to equal numbers then have numbers that are almost equal.
  int noise_ulps = 0;
};

/// Control points and velocities of one side in space; what stands in positions is where they are
/// at t*.
MovingPatch<Dyadic> placed(const ContactSide& side, const Placement& placement, const Dyadic& t);

/// A control net in the plane z = 0: a grid of up to 2^3 across, its points moved by up to an
/// eighth of its steps, or straight. Multiples of 2^-10.
Points<Dyadic> flat_net(const Shape& shape, bool straight, Draw& draw);

/// The same, moved so that the contact is the origin.
ContactSide flat_side(const Shape& shape, const Uv<Dyadic>& at, bool straight, Draw& draw);

/// Moves the points along x and y so that the contact is above the origin again.
void centre(ContactSide& side);

/// Raises each control point by its height.
void raise(Points<Dyadic>& points, const std::vector<Dyadic>& heights);

/// Turns a patch 1 above the contact plane into a patch 2 below it.
void turn_over(ContactSide& side);

/// Velocities under which patch 1 falls and patch 2 rises, all differently: a moving plane
/// separates them before t*.
void let_approach(ContactScene& scene, Draw& draw);

/// The query of the scene to t_max, and its truth. If they touch, that is the contact, by its exact
/// witness. If the patches are separated before t*, it is also clear_until = t* by the moving
/// plane, which the checker has accepted. nullopt if a number is not a double.
std::optional<Case> to_case(const ContactScene& scene, const Placement& placement, Draw& draw);

}  // namespace ccdfuzz
