#pragma once

#include "generators/contact.hpp"
#include "generators/draw/draw.hpp"

namespace ccdfuzz {

/// x += by. Returns false, and leaves x, if the sum is not a double.
bool add_exactly(double& x, const Dyadic& by);
bool add_exactly(Vec3<double>& x, const Vec3<Dyadic>& by);
/// The same of each point; false if the sum of one is not.
bool add_exactly(Points<double>& points, const Vec3<Dyadic>& by);

/// v / by, if that is dyadic.
std::optional<Vec3<Dyadic>> divided(const Vec3<Dyadic>& v, const Dyadic& by);

/// Multiplies each control point's weight by a power of two from 2^-most to 2^most. Divides the way
/// from the contact to the control point at that time by the same. So the contact stays, and so
/// does a plane through it that the patch is on one side of. Leaves a point as it is. Returns false
/// if a number is not a double; q is then void.
bool pull_by_weights(Draw& draw, Contact& q, size_t side, int most);

/// Weights of any kind (draw_patch_weights) for the control points of a rational patch that have no
/// share in the contact. Those without weights stay as they are.
void draw_free_weights(Draw& draw, Contact& q, size_t side);

/// A contact at these parameters. Most patches have weights of any kind, and control points in
/// pairs, of which each makes up for the other. nullopt if a number is not a double.
std::optional<Contact> draw_balanced_contact(Draw& draw, const std::array<Shape, 2>& shapes,
                                             const std::array<Uv<Dyadic>, 2>& uv);

}  // namespace ccdfuzz
