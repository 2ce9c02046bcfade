#pragma once

#include <span>

#include "generators/attempts.hpp"
#include "generators/shaped/contact_scene.hpp"

namespace ccdfuzz {

using ShapePair = std::array<Shape, 2>;

/// A scene, and where to put it.
struct PlacedScene {
  ContactScene scene;
  Placement placement;
};

/// What is known of a family.
struct FamilyRow {
  using Make = PlacedScene(ContactClass contact, const ShapePair& shapes, Draw& draw);
  using Fits = bool(ContactClass contact, const ShapePair& shapes);

  Family family;
  std::string_view name;
  std::string_view description;  ///< in a few words, without a full stop
  /// The classes that it has, of each kind in turn: RP, RN, NHP, NMN. RN, where a moving plane
  /// separates them before t*.
  std::array<std::span<const ContactClass>, kCaseKinds.size()> classes;
  /// A scene of any shapes that have the features of the class and fit. Null for those that are
  /// made in another way.
  Make* make = nullptr;
  Fits* fits = nullptr;        ///< null: all shapes do
  Attempt* attempt = nullptr;  ///< null: those of patches with velocities, without weights or loops
};

const FamilyRow& row_of(Family family);
/// True iff no shapes may be asked for.
bool has_own_shapes(Family family);

/// A random frame; shift and drift of many bits, as large as the patches.
Placement random_placement(Draw& draw);

/// How many bits a number may have.
struct BitRange {
  int least = 1, most = 1;
};

/// Two patches that touch in the contact plane, each on its own side of it, and do not move yet.
/// Parameters have parameter_bits bits, or what of their range is next to it.
ContactScene touching_at(ContactClass contact, const ShapePair& shapes, BitRange of_parameters,
                         long height_unit, Draw& draw);
/// A one-sided scene: Steps I, II and IV in one go, without solving or discarding anything. The
/// patches touch in one point, each on its own side of the contact plane, and approach each other.
/// A degree of 1 can leave a patch flat, and its contact a line or an area. t* = t_max = 1.
/// most_flatness: heights are the size of the patch times 2^-f, f up to this. With 6 they are a
/// 64th of it or more, as of surfaces that are plainly curved; flat_grazing asks for thinner ones.
ContactScene touching(ContactClass contact, const ShapePair& shapes, Draw& draw,
                      int most_flatness = 6);

/// The regular scene with all velocities in the contact plane, for near-hits and near-misses; the
/// latter has patch 2 moved away by 2^-20 to 2^-8.
PlacedScene grazing_variant(bool near_miss, ContactClass contact, const ShapePair& shapes,
                            Draw& draw);

namespace families {

/// moving_variants.cpp: `touching`, or varied in its motion or its scale.
FamilyRow::Make regular, interior_time, at_start, resting, sliding, flat_grazing, common_velocity,
    scaled;

/// odd_variants.cpp: varied in its shape or its numbers.
FamilyRow::Make degenerate, sliver, high_curvature, mixed_scales, far_away, concurrent_lines;

/// extended_contacts.cpp: more than one point, all in the contact plane but for area, at
/// t* = t_max = 1. The contact that the scene names is one of them.
///   shared_edge  an edge of one patch is a part of an edge of the other, or all of it
///   ruled        one patch touches the flat other one along a line of its parameters
///   several      one patch touches the straight other one in two points, or more
///   area         one patch is a part of the other: both flat, or curved and moved by one velocity
/// Before t* the plane separates the patches, but curved ones of area, and several of FF, whose
/// heights the checker does not see to be ≥ 0.
FamilyRow::Make shared_edge, ruled, several, area;
FamilyRow::Fits have_edges_alike, have_a_line, have_two_points, are_equal_surfaces;

/// True iff a patch has more than one control point.
FamilyRow::Fits have_weights;
/// True iff a patch may be trimmed.
FamilyRow::Fits have_a_surface;

}  // namespace families
}  // namespace ccdfuzz
