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

inline constexpr FamilyRow::Classes kAllClasses = kContactClasses;
inline constexpr std::array kAllButFF = {ContactClass::kEF, ContactClass::kEE, ContactClass::kVF,
                                         ContactClass::kVE, ContactClass::kVV};
/// By default none.
constexpr FamilyRow::ClassesOfKinds classes(FamilyRow::Classes positives,
                                            FamilyRow::Classes negatives = {},
                                            FamilyRow::Classes near_hits = {},
                                            FamilyRow::Classes near_misses = {}) {
  return {positives, negatives, near_hits, near_misses};
}

/// The rows of each file that makes cases: moving_variants.cpp, odd_variants.cpp,
/// extended_contacts.cpp, generate.cpp, and those of the folder above.
std::span<const FamilyRow> moving_families();
std::span<const FamilyRow> odd_families();
std::span<const FamilyRow> extended_families();
std::span<const FamilyRow> other_families();
std::span<const FamilyRow> body_families();
std::span<const FamilyRow> weighted_families();
std::span<const FamilyRow> round_families();
std::span<const FamilyRow> trimmed_families();
std::span<const FamilyRow> ends_families();
std::span<const FamilyRow> separated_families();
std::span<const FamilyRow> turning_families();
std::span<const FamilyRow> mesh_families();

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
