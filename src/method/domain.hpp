#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "case/body_kind.hpp"
#include "case/case.hpp"

namespace ccdfuzz {

/// Radians. The second is less than a half turn, by which code that is given two poses turns.
inline constexpr double kSmallSpin = std::numbers::pi / 4, kShortSpin = 3;

/// The queries that a method promises to answer, beyond its Features, or that a hunt is about; by
/// default all.
struct Domain {
  /// Shapes up to a degree; hulls up to so many points.
  struct Side {
    ShapeKind shape = ShapeKind::kPoint;
    std::uint32_t max_degree = 0;
  };
  /// They may be asked together, in either order.
  using Pair = std::array<Side, 2>;
  std::vector<Pair> pairs = {};  ///< empty: all
  BodyKinds body_kinds = {};     ///< empty: all
  /// Each number is 0 or of a magnitude in [2^-scale, 2^scale]; a separation may be smaller. Each
  /// stays_within that.
  std::optional<int> scale = {};
  /// Each number is a float, and bodies are given as floats (body_motion.hpp).
  bool binary32 = false;
  /// Only cases of Setting::kOrdinary that are not shallow: apart at the start, with extent, in
  /// motion, and with a contact that a little motion does not avoid.
  bool ordinary = false;
  /// Beside ordinary cases, those of convex bodies that touch or overlap at 0. It needs `ordinary`.
  bool initial_overlap = false;
  /// Bodies lie and move in the plane z = 0.
  bool plane = false;
  /// The most that bodies spin by in the step: kSmallSpin or kShortSpin.
  std::optional<double> most_spin = {};

  /// Whether the patches of a query must be swapped to be one of the pairs; absent: they are none.
  std::optional<bool> order_of(const Query& query) const;
  /// Which of the rules but the pairs a query breaks, in words; empty if none. The kinds
  /// of bodies are no rule for a mesh, and `ordinary` is none for a query.
  std::string broken_by(const Query& query) const;
  std::string broken_by(const Case& value) const;
  /// What lies in both. Nothing if they have no pair in common.
  std::optional<Domain> with(const Domain& other) const;
  /// "point and triangle(1)": each of the pairs.
  std::vector<std::string> pair_texts() const;
  /// In a few words, without the pairs; empty: all.
  std::string text() const;
};

/// Whether the control points of patches are within 2^scale, at t_max, too. Whether a body moves by
/// no more than that along an axis, nor both against each other.
bool stays_within(const Query& query, int scale);

/// Vertex-face and edge-edge: the pairs of a linear mesh.
inline std::vector<Domain::Pair> linear_pairs() {
  return {{{{ShapeKind::kPoint, 0}, {ShapeKind::kTriangle, 1}}},
          {{{ShapeKind::kCurve, 1}, {ShapeKind::kCurve, 1}}}};
}

}  // namespace ccdfuzz
