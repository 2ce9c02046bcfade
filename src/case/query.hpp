#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "bezier/patch.hpp"

namespace ccdfuzz {

/// A CCD query: are two moving patches in contact at some t in the closed [0, t_max], and when
/// first? (Eq. 1). They are where a point of one is no farther than `separation` from a point of
/// the other; with 0, where they touch. All numbers finite, t_max ≥ 0, and ≤ 1 where a patch has
/// ends or turns; separation ≥ 0, radius ≥ 0; weights as kWeightBits says; loops as fault_of
/// (trim.hpp) says. Both patches are hulls, or neither is.
/// One hull may be a mesh (mesh.hpp), beside one that does not turn.
struct Query {
  std::array<MovingPatch<double>, 2> patches;
  double t_max = 1;
  double separation = 0;

  friend bool operator==(const Query&, const Query&) = default;
};

/// Calls visit on each number of a patch: the coordinates of the positions, point by point, then of
/// the velocities or ends. Those of a hull include the radius, and the centre of its turn.
template <class Patch, class Visit>
void for_each_coordinate(Patch& patch, const Visit& visit) {
  for (auto* points : {&patch.positions, &patch.velocities, &patch.ends}) {
    for (auto& p : *points) {
      for (int k = 0; k < 3; ++k) visit(p[k]);
    }
  }
  if (patch.shape.kind != ShapeKind::kHull) return;
  visit(patch.radius);
  if (patch.turn)
    visit(patch.turn->centre[0]), visit(patch.turn->centre[1]), visit(patch.turn->centre[2]);
}

/// Calls visit on each number of a turn but its centre's.
template <class Patch, class Visit>
void for_each_turn_number(Patch& patch, const Visit& visit) {
  if (!patch.turn) return;
  for (auto* numbers : {&patch.turn->from, &patch.turn->to, &patch.turn->spin}) {
    for (auto& x : *numbers) visit(x);
  }
}

/// Calls visit on each number of a patch: those, its weights, and the vertices of its loops.
template <class Patch, class Visit>
void for_each_number(Patch& patch, const Visit& visit) {
  for_each_coordinate(patch, visit);
  for_each_turn_number(patch, visit);
  for (auto& w : patch.weights) visit(w);
  for (auto& loop : patch.trim) {
    for (auto& vertex : loop) visit(vertex[0]), visit(vertex[1]);
  }
}

/// The same of both patches of a query, t_max and the separation.
template <class Whole, class Visit>
requires requires(Whole& query) {
  query.patches;
}
void for_each_number(Whole& query, const Visit& visit) {
  for (auto& patch : query.patches) for_each_number(patch, visit);
  visit(query.t_max);
  visit(query.separation);
}

/// True iff both patches are hulls, as of a valid query one is only if both are.
inline bool is_of_bodies(const Query& query) {
  return query.patches[0].shape.kind == ShapeKind::kHull &&
         query.patches[1].shape.kind == ShapeKind::kHull;
}

bool has_ends(const Query& query);
/// One of its bodies turns; or turns by a spin.
bool has_turns(const Query& query);
bool has_spins(const Query& query);
/// Whether t is past 1 of a query in which a patch has ends or turns: its motion ends there.
bool is_past_motion(const Query& query, double t);
/// What is at t = 1 of such a query.
std::string_view end_of_motion(const Query& query);
/// A patch has weights that are not all equal.
bool is_rational(const Query& query);

bool is_trimmed(const Query& query);

/// Binary exponents of a patch's weights differ by at most this. Then what products with weights
/// lose to underflow stays below the least absolute error of tdibm-c. For let lengths be 1 and
/// weights in [2^-60, 2): each product loses 2^-1075, which over a weight is 2^-1015. A few
/// thousand of these are below 2^-1000.
inline constexpr int kWeightBits = 60;
/// All finite, > 0 and of such exponents.
bool are_weights(const std::vector<double>& weights);

/// The weights of a rational patch times the power of two that brings the largest into [1, 2),
/// exactly. Other patches have none. shift, if given, gets the exponent.
std::vector<double> scaled_weights(const MovingPatch<double>& patch, int* shift = nullptr);

/// The query without weights, if those of each patch are equal; it is the same.
std::optional<Query> without_weights(const Query& query);

/// The query with velocities, if all ends − positions are doubles; it is the same motion.
std::optional<Query> with_velocities(const Query& query);

/// Control point i's end − position, or its velocity, rounded: for what is only weighed or shown.
inline Vec3<double> rounded_velocity(const MovingPatch<double>& patch, size_t i) {
  return patch.has_ends() ? Vec3<double>(patch.ends[i] - patch.positions[i]) : patch.velocity(i);
}

/// Gives a patch with velocities the ends positions + velocities, each rounded, in their place.
void give_rounded_ends(MovingPatch<double>& patch);

/// What is wrong with a query of any bits, in which of its fields, with its value and what it may
/// be; nullopt if nothing is. Allocates nothing then, but for trims and turns.
std::optional<InputError> fault_of(const Query& query);
inline bool is_valid(const Query& query) {
  return !fault_of(query);
}

}  // namespace ccdfuzz
