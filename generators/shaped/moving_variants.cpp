#include <algorithm>

#include "generators/paper.hpp"
#include "generators/shaped/families.hpp"
#include "generators/shaped/heights.hpp"

namespace ccdfuzz {

namespace {

// Heights are multiples of 2^-9 times the squares of parameters, below about 2^4.
constexpr long kBowlUnit = -9;
constexpr BitRange kManyBits = {1, 12}, kFewBits = {1, 2};  // of parameters

/// A multiple of 1/8 in (0, 1).
Dyadic time_before_one(Draw& draw) {
  return {draw.integer(1, 7), -3};
}

/// Velocities along the contact plane: heights above it never change.
void let_graze(ContactScene& scene, Draw& draw) {
  let_approach(scene, draw);
  for (ContactSide& side : scene.sides) {
    for (Vec3<Dyadic>& rate : side.rates) rate[2] = Dyadic();
  }
  scene.separated = false;
}

/// Any velocities at all: the contact at t = 0 is there whatever comes then.
void let_start(ContactScene& scene, Draw& draw) {
  let_approach(scene, draw);
  const std::uint64_t style = draw.below(3);  // cross, leave, anything
  for (ContactSide& side : scene.sides) {
    for (Vec3<Dyadic>& rate : side.rates) {
      if (style == 1 || (style == 2 && draw.coin())) rate[2] = -rate[2];
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

}  // namespace

Placement random_placement(Draw& draw) {
  Placement placement;
  placement.frame = random_frame(draw);
  placement.shift = draw.vector(40, -35);
  placement.drift = draw.vector(17, -15);
  return placement;
}

ContactScene touching_at(ContactClass contact, const ShapePair& shapes, BitRange of_parameters,
                         long height_unit, Draw& draw) {
  ContactScene scene;
  for (size_t s = 0; s < 2; ++s) {
    const Shape& shape = shapes[s];
    const int bits = std::clamp(parameter_bits(shape), of_parameters.least, of_parameters.most);
    const Uv<Dyadic> at = point_on(features_of(contact)[s], shape, bits, draw);
    scene.sides[s] = flat_side(shape, at, false, draw);
    raise(scene.sides[s].points, heights_over(shape, at, ZeroSet::kPoint, height_unit, draw));
  }
  turn_over(scene.sides[1]);
  return scene;
}

ContactScene touching(ContactClass contact, const ShapePair& shapes, Draw& draw,
                      int most_flatness) {
  const std::int64_t flatness = draw.integer(0, most_flatness);
  const long unit = kBowlUnit - static_cast<long>(flatness);
  ContactScene scene = touching_at(contact, shapes, kManyBits, unit, draw);
  let_approach(scene, draw);
  return scene;
}

PlacedScene regular_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made;
  made.placement = random_placement(draw);
  made.scene = touching(contact, shapes, draw);
  return made;
}

PlacedScene interior_time_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  made.scene.t = time_before_one(draw);
  return made;
}

PlacedScene at_start_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  let_start(made.scene, draw);
  return made;
}

PlacedScene resting_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  let_rest(made.scene);
  return made;
}

PlacedScene common_velocity_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  const long exponent = draw.integer(8, 20);
  made.placement.drift = draw.vector(10, exponent - 10);
  return made;
}

PlacedScene scaled_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  made.scene.t_max = 2;
  // Most where products of two projections underflow; a subnormal has no room for all bits.
  const bool near_underflow = draw.below(4) != 0;
  const auto exponent =
      static_cast<long>(near_underflow ? draw.integer(-547, -530) : draw.integer(-1000, 900));
  made.placement.exponent.fill(exponent);
  return made;
}

/// One patch, the plate, is flat with straight edges and moves rigidly. The other touches its plane
/// in one point, which slides onto the plate at t* and stays in touch while it is there. t* is the
/// first contact if that point comes over the plate's boundary.
PlacedScene sliding_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made;
  made.placement = random_placement(draw);
  ContactScene& scene = made.scene;
  scene = touching_at(contact, shapes, kManyBits, kBowlUnit, draw);
  let_graze(scene, draw);
  const size_t p = plate_of(contact);
  ContactSide &plate = scene.sides[p], &slider = scene.sides[1 - p];
  plate = flat_side(plate.shape, plate.at, true, draw);
  const Vec3<Dyadic> still = {Dyadic(), Dyadic(), Dyadic()};
  plate.rates.assign(plate.points.size(), still);
  const Vec3<Dyadic> inwards = draw.until(
      [&] {
        Vec3<Dyadic> sum = still;
        for (const Vec3<Dyadic>& p_i : plate.points) {
          sum += p_i * Dyadic(draw.integer(1, 8), -3);
        }
        return sum;
      },  // a point has no inside
      [&](const Vec3<Dyadic>& v) { return v != still || plate.points.size() == 1; });
  // All of the slider by the same velocity, and a little deformation that the contact has no share
  // in: that of control points without weight there.
  slider.rates.assign(slider.points.size(), inwards);
  for_each_control(slider.shape, [&](int i, int j) {
    if (bears(slider.shape, slider.at, i, j)) return;
    Vec3<Dyadic>& rate = slider.rates[static_cast<size_t>(slider.shape.index(i, j))];
    for (int k = 0; k < 2; ++k) rate[k] += draw.lattice(6, -8);
  });
  scene.t = time_before_one(draw);
  return made;
}

/// Nearly flat, far away on a plane through the origin that is the contact plane. Parameters have
/// few bits, so that heights of 2^-20 and coordinates up to 2^16 fit into one double.
PlacedScene flat_grazing_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  constexpr long kFlatness = 20;
  PlacedScene made;
  made.placement.frame = random_frame(draw);
  made.scene = touching_at(contact, shapes, kFewBits, kBowlUnit - kFlatness, draw);
  let_graze(made.scene, draw);
  if (draw.coin()) made.scene.t = time_before_one(draw);
  const int bits = draw.integer(32, 38);
  const Planar where = {draw.lattice(bits, -28), draw.lattice(bits, -28)};
  made.placement.shift = point_of(made.placement.frame, where, Dyadic());
  return made;
}

PlacedScene grazing_variant(bool near_miss, ContactClass contact, const ShapePair& shapes,
                            Draw& draw) {
  PlacedScene made = regular_variant(contact, shapes, draw);
  let_graze(made.scene, draw);
  if (near_miss) {
    const Dyadic gap(1, draw.integer(kLeastGap, kLargestGap));
    for (Vec3<Dyadic>& p : made.scene.sides[1].points) p[2] -= gap;
    made.scene.touches = false;
  }
  return made;
}

}  // namespace ccdfuzz
