#pragma once

#include <span>
#include <variant>

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
  using Classes = std::span<const ContactClass>;
  /// Those of RP, RN, NHP and NMN. RN, where a moving plane separates them before t*.
  using ClassesOfKinds = std::array<Classes, kCaseKinds.size()>;
  using Make = PlacedScene(ContactClass contact, const ShapePair& shapes, Draw& draw);
  using Fits = bool(ContactClass contact, const ShapePair& shapes);

  Family family{};
  std::string_view name;
  std::string_view description;  ///< in a few words, without a full stop
  ClassesOfKinds classes{};      ///< those that it has
  /// A scene, of patches with velocities, without weights or loops; or one attempt at a case.
  /// Neither: generate() makes them by itself.
  std::variant<std::monostate, Make*, Attempt*> made_by{};
  Fits* fits =
      nullptr;  ///< the shapes that it can have beside the features of the class; null: all
};

// What makes them: moving_variants.cpp, odd_variants.cpp, extended_contacts.cpp, and files of the
// folder above (bodies.hpp has framed_bodies).
FamilyRow::Make regular_variant, flat_grazing_variant, common_velocity_variant, scaled_variant,
    interior_time_variant, at_start_variant, resting_variant, sliding_variant, degenerate_variant,
    sliver_variant, high_curvature_variant, mixed_scales_variant, far_away_variant,
    concurrent_lines_variant, touching_along_edges, touching_along_a_line, touching_at_points,
    touching_over_an_area;
Attempt grazing_bodies_case, weighted_case, round_case, trimmed_case, ends_case, separated_case,
    turning_case, spinning_case, mesh_case;
FamilyRow::Fits have_edges_alike, have_a_line, have_two_points, are_equal_surfaces, have_weights,
    have_a_surface;

/// The one of a family.
const FamilyRow& row_of(Family family);
/// Fits, of a family with shapes of its own: none may be asked for.
FamilyRow::Fits own_shapes;
inline bool has_own_shapes(Family family) {
  return row_of(family).fits == own_shapes;
}

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

}  // namespace ccdfuzz
