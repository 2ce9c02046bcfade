#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/body_kind.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

/// The queries that a method promises to answer, beyond its Features, or that a hunt is about; by
/// default all.
struct Domain {
  /// Shapes that may be asked together, in either order, up to these degrees; hulls up to so many
  /// points.
  struct Pair {
    std::array<ShapeKind, 2> shapes;
    std::array<int, 2> max_degrees;
  };
  std::vector<Pair> pairs;  ///< empty: all
  BodyKinds body_kinds;     ///< empty: all
  /// Each number is 0 or of a magnitude in [2^-scale, 2^scale].
  std::optional<int> scale;
  /// Each number is a float.
  bool binary32 = false;
  /// Only cases of Setting::kOrdinary that are not shallow: apart at the start, with extent, in
  /// motion, and with a contact that a little motion does not avoid.
  bool ordinary = false;
  /// Bodies lie and move in the plane z = 0.
  bool plane = false;

  /// Whether the patches of a query must be swapped to be one of the pairs; absent: they are none.
  std::optional<bool> order_of(const Query& query) const;
  /// Whether a query is of those bodies, if of any. A mesh is none of the kinds.
  bool has_bodies_of(const Query& query) const;
  /// Whether the numbers of a query are of that scale and width, and bodies in that plane.
  bool has_numbers_of(const Query& query) const;
  /// Which of the rules but the pairs a case breaks, in words; empty if none.
  std::string broken_by(const Case& value) const;
  /// What lies in both. Nothing if they have no pair in common.
  std::optional<Domain> with(const Domain& other) const;
  /// In a few words, without the pairs; empty: all.
  std::string text() const;
};

/// Vertex-face and edge-edge: the pairs of a linear mesh.
inline std::vector<Domain::Pair> linear_pairs() {
  return {{{ShapeKind::kPoint, ShapeKind::kTriangle}, {0, 1}},
          {{ShapeKind::kCurve, ShapeKind::kCurve}, {1, 1}}};
}

}  // namespace ccdfuzz
