#include <algorithm>

#include "generators/shaped/families.hpp"

namespace ccdfuzz {

namespace {

constexpr int kDoubleBits = 53;
constexpr BitRange kFewParameterBits = {2, 2};
constexpr long kCoarseHeightUnit = -9;
/// Coordinates in space are below 2^10 before anything is moved or scaled: frame vectors below 2^5
/// times numbers below 2^3 or so, three of them.
constexpr long kSizeExponent = 10;
constexpr int kLeastSqueeze = 4;  // of a sliver: 2^-4

/// A regular scene whose numbers have so few bits that there is room for more.
ContactScene coarse_scene(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  ContactScene scene = touching_at(contact, shapes, kFewParameterBits, kCoarseHeightUnit, draw);
  let_approach(scene, draw);
  return scene;
}

/// All numbers of the scene are multiples of 2 to this.
long finest_exponent(const ContactScene& scene) {
  long finest = 0;
  for (const ContactSide& side : scene.sides) {
    for (const Points<Dyadic>* points : {&side.points, &side.rates}) {
      for (const Vec3<Dyadic>& p : *points) {
        for (int k = 0; k < 3; ++k) {
          if (p[k].sign() != 0) finest = std::min(finest, p[k].exponent());
        }
      }
    }
  }
  return finest;
}

/// Bits that a double has left beside those of the scene.
int spare_bits(const ContactScene& scene) {
  return static_cast<int>(std::max(1L, kDoubleBits - 1 - kSizeExponent + finest_exponent(scene)));
}

void scale_axes(Points<Dyadic>& points, int first_axis, int last_axis, long exponent) {
  for (Vec3<Dyadic>& p : points) {
    for (int k = first_axis; k <= last_axis; ++k) p[k] = p[k].scaled(exponent);
  }
}

/// Ways in which the control points of a patch can fall together. Its heights are 0, or 0 where it
/// has a share in the contact and equal elsewhere. Only points of equal height fall together, so
/// the patch stays on its side of the contact plane.
void make_degenerate(ContactSide& side, Draw& draw) {
  const Shape& shape = side.shape;
  const auto merge = [&](size_t to, size_t from) {
    if (side.points[to][2] != side.points[from][2]) return;
    side.points[to] = side.points[from];
    side.rates[to] = side.rates[from];
  };
  const size_t count = side.points.size();
  const std::vector<ShapeEdge> edges = edges_of(shape);
  switch (edges.empty() ? 3 : draw.below(4)) {
    case 0: {  // an edge is one point
      const std::vector<size_t> places = edges[draw.below(edges.size())].controls(shape);
      for (const size_t place : places) merge(place, places[0]);
      break;
    }
    case 1: {  // some control points are there twice
      for (std::uint64_t pairs = draw.integer(1, 3); pairs > 0; --pairs) {
        const size_t to = draw.below(count);
        merge(to, draw.below(count));
      }
      break;
    }
    case 2:  // all on a line: no area
      for (Vec3<Dyadic>& p : side.points) p[1] = p[0].scaled(1);
      break;
    default:  // the patch is one point, or two
      for (size_t i = 1; i < count; ++i) merge(i, draw.below(i));
      break;
  }
  centre(side);
}

/// Sets velocities with which all control points of the side pass through one point at one time.
/// Their lines on any axis then cross in one point. Patch 1 falls and patch 2 rises, so that point
/// is beyond all of the patch if it comes after t*, else before it.
void pass_through_a_point(ContactSide& side, bool upper, bool after, long rate_exponent,
                          Draw& draw) {
  Dyadic lowest, highest;
  for (const Vec3<Dyadic>& p : side.points) {
    lowest = std::min(lowest, p[2]);
    highest = std::max(highest, p[2]);
  }
  const Dyadic clear(1, -draw.integer(1, 6));
  Vec3<Dyadic> focus = draw.vector(6, -5);
  focus[2] = after == upper ? lowest - clear : highest + clear;
  side.rates.clear();
  for (const Vec3<Dyadic>& p : side.points) {
    side.rates.push_back((focus - p) * Dyadic(after ? 1 : -1, rate_exponent));
  }
}

/// A coarse scene to be changed, near the origin.
PlacedScene near_origin(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made;
  made.placement.frame = random_frame(draw);
  made.placement.shift = draw.vector(4, 0);
  made.scene = coarse_scene(contact, shapes, draw);
  return made;
}

/// One side of the scene, the other, or both.
template <class Change>
void change_sides(ContactScene& scene, Draw& draw, const Change& change) {
  const std::uint64_t which = draw.integer(1, 3);  // bits: patch 1, patch 2
  for (size_t s = 0; s < 2; ++s) {
    if ((which >> s & 1) != 0) change(s, scene.sides[s]);
  }
}

}  // namespace

PlacedScene concurrent_lines_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = near_origin(contact, shapes, draw);
  ContactScene& scene = made.scene;
  scene.t = Dyadic(1, -1);
  const std::uint64_t which = draw.integer(1, 3);  // bits: patch 1, patch 2
  const bool after = draw.coin();
  const int sooner = draw.integer(1, 4);  // that point is 2^-sooner from t*
  for (size_t s = 0; s < 2; ++s) {
    if ((which >> s & 1) == 0) continue;
    ContactSide& side = scene.sides[s];
    if (draw.below(4) == 0) {
      // It passes through the contact point itself: all of the patch is there at t*.
      for (Vec3<Dyadic>& p : side.points) p = {Dyadic(), Dyadic(), Dyadic()};
    } else {
      pass_through_a_point(side, s == 0, after, sooner, draw);
    }
  }
  made.placement.noise_ulps = draw.integer(0, 4);
  return made;
}

/// One patch much smaller than the other one; in space coordinates of different sizes too, up to
/// the ends of what a double holds.
PlacedScene mixed_scales_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = near_origin(contact, shapes, draw);
  const int shrink = -draw.integer(1, spare_bits(made.scene));
  ContactSide& smaller = made.scene.sides[draw.below(2)];
  scale_axes(smaller.points, 0, 2, shrink);
  if (draw.coin()) scale_axes(smaller.rates, 0, 2, shrink);
  const bool one_size = draw.coin();
  const int common = draw.integer(-900, 800);
  for (long& exponent : made.placement.exponent) {
    exponent = one_size ? common : draw.integer(-60, 60);
  }
  return made;
}

/// As far from the origin as the numbers have bits for.
PlacedScene far_away_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made;
  made.placement.frame = random_frame(draw);
  made.scene = coarse_scene(contact, shapes, draw);
  const int spare = spare_bits(made.scene);
  const int reach = draw.integer(spare / 2, spare);
  made.placement.shift = draw.vector(8, kSizeExponent + reach - 8);
  if (draw.coin()) made.placement.drift = draw.vector(8, kSizeExponent + reach - 10);
  return made;
}

PlacedScene degenerate_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = near_origin(contact, shapes, draw);
  change_sides(made.scene, draw, [&](size_t s, ContactSide& side) {
    const bool lift = draw.coin();
    const Dyadic height(s == 0 ? 1 : -1, -draw.integer(2, 8));
    for_each_control(side.shape, [&](int i, int j) {
      Dyadic& z = side.points[static_cast<size_t>(side.shape.index(i, j))][2];
      z = lift && !bears(side.shape, side.at, i, j) ? height : Dyadic();
    });
    make_degenerate(side, draw);
  });
  return made;
}

PlacedScene sliver_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = near_origin(contact, shapes, draw);
  const int most = std::max(kLeastSqueeze, spare_bits(made.scene));
  change_sides(made.scene, draw, [&](size_t, ContactSide& side) {
    scale_axes(side.points, 1, 1, -draw.integer(kLeastSqueeze, most));
  });
  return made;
}

PlacedScene high_curvature_variant(ContactClass contact, const ShapePair& shapes, Draw& draw) {
  PlacedScene made = near_origin(contact, shapes, draw);
  change_sides(made.scene, draw, [&](size_t, ContactSide& side) {
    scale_axes(side.points, 2, 2, draw.integer(4, 12));
  });
  return made;
}

}  // namespace ccdfuzz
