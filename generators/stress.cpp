#include "generators/stress.hpp"

#include "generators/one_sided.hpp"
#include "generators/twins.hpp"

namespace ccdfuzz {

namespace {

/// A multiple of 1/8 in (0, 1).
Dyadic interior_time(Draw& draw) {
  return {Integer(static_cast<long>(draw.integer(1, 7))), -3};
}

Scene flat_grazing(ContactClass contact, Draw& draw) {
  OneSidedStyle style;
  if (draw.coin()) style.t = interior_time(draw);
  // Coordinates up to 2^10 .. 2^16. Finest bit: 2^-8-20-4 from the heights, 2^-3 more from t*.
  style.contact_bits = static_cast<int>(draw.integer(36, 42));
  style.contact_unit = -32;
  style.plane_through_origin = true;
  style.max_parameter_bits = 2;
  style.min_flatness = style.max_flatness = 20;
  style.grazing = true;
  return one_sided_scene(contact, style, draw);
}

Scene common_velocity(ContactClass contact, Draw& draw) {
  OneSidedStyle style;
  Scene scene = one_sided_scene(contact, style, draw);
  const long exponent = static_cast<long>(draw.integer(8, 20));
  const Vec3<Dyadic> common = draw.vector(10, exponent - 10);
  // Positions stay: the contact, as seen from the patches, is the same, and lies far away.
  for (MovingPatch<Dyadic>& patch : scene.patches) {
    for (Vec3<Dyadic>& v : patch.velocities) v += common;
  }
  return scene;
}

Scene scaled(ContactClass contact, Draw& draw) {
  OneSidedStyle style;
  style.t_max = 2;
  Scene scene = one_sided_scene(contact, style, draw);
  // Coordinates are about 2^5 to 2^7 before. The products of two projections in Steps II and III
  // underflow from 2^-537 down. The end is at 2^-1000, as a subnormal has no room for 52 bits.
  const long exponent = draw.below(4) != 0 ? static_cast<long>(draw.integer(-547, -530))
                                           : static_cast<long>(draw.integer(-1000, 900));
  for (MovingPatch<Dyadic>& patch : scene.patches) {
    for (Points<Dyadic>* points : {&patch.positions, &patch.velocities}) {
      for (Vec3<Dyadic>& p : *points) {
        for (int k = 0; k < 3; ++k) p[k] = p[k].scaled(exponent);
      }
    }
  }
  return scene;
}

Scene interior_contact(ContactClass contact, Draw& draw) {
  OneSidedStyle style;
  style.t = interior_time(draw);
  return one_sided_scene(contact, style, draw);
}

}  // namespace

Scene stress_scene(Family family, ContactClass contact, Draw& draw) {
  switch (family) {
    case Family::kFlatGrazing:
      return flat_grazing(contact, draw);
    case Family::kCommonVelocity:
      return common_velocity(contact, draw);
    case Family::kScaled:
      return scaled(contact, draw);
    case Family::kTwins:
      return twin_scene(contact, draw);
    case Family::kInteriorTime:
      return interior_contact(contact, draw);
    default:
      break;
  }
  throw InternalError("no quadratic family");
}

}  // namespace ccdfuzz
