#include <algorithm>

#include "generators/grazing.hpp"
#include "generators/shaped/heights.hpp"
#include "generators/shaped/point_contacts.hpp"

namespace ccdfuzz {

namespace {

// Heights are multiples of 2^-9 times the squares of parameters, below about 2^4.
constexpr long kBowlUnit = -9;
constexpr int kMostFlatness = 6;
constexpr int kManyBits = 12, kFewBits = 2;  // of parameters

/// A multiple of 1/8 in (0, 1).
Dyadic time_before_one(Random& random) {
  return {Integer(static_cast<long>(random.between(1, 7))), -3};
}

/// most_bits: of parameters.
ContactScene touching_at(ContactClass contact, const ShapePair& shapes, int most_bits,
                         long height_unit, Random& random) {
  ContactScene scene;
  for (size_t s = 0; s < 2; ++s) {
    const Shape& shape = shapes[s];
    const int bits = std::min(most_bits, parameter_bits(shape));
    const Uv<Dyadic> at = point_on(features_of(contact)[s], shape, bits, random);
    scene.sides[s] = flat_side(shape, at, false, random);
    raise(scene.sides[s].points, heights_over(shape, at, ZeroSet::kPoint, height_unit, random));
  }
  turn_over(scene.sides[1]);
  return scene;
}

/// Velocities along the contact plane: heights above it never change.
void let_graze(ContactScene& scene, Random& random) {
  let_approach(scene, random);
  for (ContactSide& side : scene.sides) {
    for (Vec3<Dyadic>& rate : side.rates) rate[2] = Dyadic();
  }
  scene.separated = false;
}

/// Any velocities at all: the contact at t = 0 is there whatever comes then.
void let_start(ContactScene& scene, Random& random) {
  let_approach(scene, random);
  const std::uint64_t style = random.below(3);  // cross, leave, anything
  for (ContactSide& side : scene.sides) {
    for (Vec3<Dyadic>& rate : side.rates) {
      if (style == 1 || (style == 2 && random.coin())) rate[2] = -rate[2];
    }
  }
  scene.t = Dyadic();
  scene.separated = false;
}

/// No patch moves relative to the other: they touch from the beginning to the end.
void let_rest(ContactScene& scene) {
  for (ContactSide& side : scene.sides) {
    side.rates.assign(side.points.size(), {Dyadic(), Dyadic(), Dyadic()});
  }
  scene.t = Dyadic();
  scene.separated = false;
}

/// The side that a sliding one slides on: a flat patch with straight edges. It is patch 2, unless
/// only patch 1 has a boundary there that the other comes across.
size_t plate_of(ContactClass contact) {
  return contact == ContactClass::kEF ? 0 : 1;
}

/// One patch is flat with straight edges and moves as a whole; the other one touches its plane in
/// one point, which slides onto the plate at t* and stays in touch while it is there; t* is the
/// first contact where it lies on the plate's boundary.
ContactScene sliding_onto_a_plate(ContactClass contact, const ShapePair& shapes, Random& random) {
  ContactScene scene = touching_at(contact, shapes, kManyBits, kBowlUnit, random);
  let_graze(scene, random);
  const size_t p = plate_of(contact);
  ContactSide &plate = scene.sides[p], &slider = scene.sides[1 - p];
  plate = flat_side(plate.shape, plate.at, true, random);
  const Vec3<Dyadic> still = {Dyadic(), Dyadic(), Dyadic()};
  plate.rates.assign(plate.points.size(), still);
  Vec3<Dyadic> inwards = still;
  while (inwards == still) {
    for (const Vec3<Dyadic>& p_i : plate.points) {
      inwards += p_i * Dyadic(static_cast<int>(random.between(1, 8)), -3);
    }
    if (plate.points.size() == 1) break;  // a point has no inside
  }
  // All of the slider by the same velocity, and a little deformation that the contact has no share
  // in: that of control points without weight there.
  slider.rates.assign(slider.points.size(), inwards);
  for_each_control(slider.shape, [&](int i, int j) {
    if (bears(slider.shape, slider.at, i, j)) return;
    Vec3<Dyadic>& rate = slider.rates[static_cast<size_t>(slider.shape.index(i, j))];
    for (int k = 0; k < 2; ++k) rate[k] += random.dyadic(6, -8);
  });
  scene.t = time_before_one(random);
  return scene;
}

/// Nearly flat, far away on a plane through the origin that is the contact plane. Parameters have
/// few bits, so that heights of 2^-20 and coordinates up to 2^16 fit into one double.
PlacedScene flat_grazing_of_shapes(ContactClass contact, const ShapePair& shapes, Random& random) {
  constexpr long kFlatness = 20;
  PlacedScene made;
  made.placement.frame = random_frame(random);
  made.scene = touching_at(contact, shapes, kFewBits, kBowlUnit - kFlatness, random);
  let_graze(made.scene, random);
  if (random.coin()) made.scene.t = time_before_one(random);
  const int bits = static_cast<int>(random.between(32, 38));
  const Planar where = {random.dyadic(bits, -28), random.dyadic(bits, -28)};
  made.placement.shift = point_of(made.placement.frame, where, Dyadic());
  return made;
}

}  // namespace

Placement random_placement(Random& random) {
  Placement placement;
  placement.frame = random_frame(random);
  placement.shift = random.vector(40, -35);
  placement.drift = random.vector(17, -15);
  return placement;
}

ContactScene touching(ContactClass contact, const ShapePair& shapes, Random& random) {
  const std::int64_t flatness = random.between(0, kMostFlatness);
  const long unit = kBowlUnit - static_cast<long>(flatness);
  ContactScene scene = touching_at(contact, shapes, kManyBits, unit, random);
  let_approach(scene, random);
  return scene;
}

PlacedScene moving_variant(Family family, ContactClass contact, const ShapePair& shapes,
                           Random& random) {
  if (family == Family::kFlatGrazing) return flat_grazing_of_shapes(contact, shapes, random);
  PlacedScene made;
  made.placement = random_placement(random);
  ContactScene& scene = made.scene;
  if (family == Family::kSliding) {
    scene = sliding_onto_a_plate(contact, shapes, random);
    return made;
  }
  scene = touching(contact, shapes, random);
  if (family == Family::kInteriorTime) scene.t = time_before_one(random);
  if (family == Family::kAtStart) let_start(scene, random);
  if (family == Family::kResting) let_rest(scene);
  if (family == Family::kCommonVelocity) {
    const long exponent = static_cast<long>(random.between(8, 20));
    made.placement.drift = random.vector(10, exponent - 10);
  }
  return made;
}

PlacedScene grazing_variant(bool near_miss, ContactClass contact, const ShapePair& shapes,
                            Random& random) {
  PlacedScene made;
  made.placement = random_placement(random);
  made.scene = touching(contact, shapes, random);
  let_graze(made.scene, random);
  if (near_miss) {
    const Dyadic gap(1, static_cast<long>(random.between(kLeastGap, kLargestGap)));
    for (Vec3<Dyadic>& p : made.scene.sides[1].points) p[2] -= gap;
    made.scene.touches = false;
  }
  return made;
}

}  // namespace ccdfuzz
