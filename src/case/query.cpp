#include "case/query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/double_parts.hpp"
#include "bezier/trim.hpp"
#include "case/mesh.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

namespace {

/// Whether no coordinate, of any bits, is NaN or infinite. Without a branch for each.
bool are_all_finite(const Points<double>& points) {
  constexpr std::uint64_t kMagnitude = ~(std::uint64_t{1} << 63);
  constexpr std::uint64_t kOneInExponent = std::uint64_t{1} << 52;
  std::uint64_t carried = 0;  // into bit 63 of those whose exponent has all bits set
  for (const Vec3<double>& p : points) {
    for (int k = 0; k < 3; ++k) {
      carried |= (std::bit_cast<std::uint64_t>(p[k]) & kMagnitude) + kOneInExponent;
    }
  }
  return carried >> 63 == 0;
}

bool is_not_negative(double x) {
  return is_finite(x) && compare(x, 0) >= 0;
}

bool is_hull(const MovingPatch<double>& patch) {
  return patch.shape.kind == ShapeKind::kHull;
}

using Fault = std::optional<InputError>;

Fault fault_of(const Shape& shape) {
  if (shape.valid()) return std::nullopt;
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return InputError{
          "", fmt::format("a point with the degrees {} and {}, which must be 0", shape.n, shape.m)};
    case ShapeKind::kCurve:
    case ShapeKind::kTriangle:
      if (shape.m == 0) break;
      return InputError{
          "", fmt::format("{} with a second degree {}, which must be 0", to_text(shape), shape.m)};
    case ShapeKind::kTensor:
      break;
    case ShapeKind::kHull:
      return InputError{"", fmt::format("{}, {}: a hull has 1..{} points, and no second number",
                                        shape.n, shape.m, kMaxControls)};
    default:
      return InputError{"", fmt::format("kind {} is none of 0 (point) to 4 (hull)",
                                        static_cast<int>(shape.kind))};
  }
  return InputError{"", fmt::format("{} has a degree outside 1..{}", to_text(shape), kMaxDegree)};
}

/// What is wrong with positions, velocities or ends.
Fault fault_of(const Points<double>& points, const Shape& shape, size_t count, const char* field) {
  if (points.size() != count) {
    return InputError{field,
                      fmt::format("has {}; {} needs {}", points.size(), to_text(shape), count)};
  }
  if (are_all_finite(points)) return std::nullopt;
  size_t at = 0;  // of a number
  while (is_finite(points[at / 3][static_cast<int>(at % 3)])) ++at;
  return InputError{fmt::format("{}[{}][{}]", field, at / 3, at % 3),
                    fmt::format("{} is not finite", points[at / 3][static_cast<int>(at % 3)])};
}

Fault fault_of_weights(const MovingPatch<double>& patch) {
  const std::vector<double>& weights = patch.weights;
  if (weights.empty()) return std::nullopt;
  if (is_hull(patch)) return InputError{"weights", "a hull has none"};
  if (weights.size() != patch.positions.size()) {
    return InputError{"weights", fmt::format("{} needs {} weights, not {}", to_text(patch.shape),
                                             patch.positions.size(), weights.size())};
  }
  if (are_weights(weights)) return std::nullopt;
  for (size_t i = 0; i < weights.size(); ++i) {
    if (is_finite(weights[i]) && compare(weights[i], 0) > 0) continue;
    return InputError{fmt::format("weights[{}]", i),
                      fmt::format("{} is not a finite number > 0", weights[i])};
  }
  const auto [least, most] = std::ranges::minmax_element(weights);
  return InputError{
      "weights",
      fmt::format("has binary exponents that differ by more than {}: {} at [{}] and {} "
                  "at [{}]",
                  kWeightBits, *least, least - weights.begin(), *most, most - weights.begin())};
}

/// What is wrong with one patch, in which of its fields.
Fault fault_of(const MovingPatch<double>& patch) {
  if (Fault fault = fault_of(patch.shape)) return fault;
  const auto count = static_cast<size_t>(patch.shape.control_count());
  if (Fault fault = fault_of(patch.positions, patch.shape, count, "positions")) return fault;
  if (patch.has_ends() && !patch.velocities.empty()) {
    return InputError{"", "has velocities and ends, and may have one of them"};
  }
  const size_t moves = is_hull(patch) ? 1 : count;
  const char* const field = patch.has_ends() ? "ends" : "velocities";
  if (Fault fault = fault_of(patch.moves(), patch.shape, moves, field)) return fault;
  if (is_hull(patch) && patch.has_ends()) return InputError{"ends", "a hull has a velocity"};
  if (!is_not_negative(patch.radius) || (!is_hull(patch) && compare(patch.radius, 0) > 0)) {
    const char* accepted = is_hull(patch) ? "a finite number ≥ 0" : "0, as of all but hulls";
    return InputError{"radius", fmt::format("{} is not {}", patch.radius, accepted)};
  }
  if (patch.turn) {
    const char* const turn = patch.turn->is_spin() ? "spin" : "turn";
    if (!is_hull(patch)) return InputError{turn, "only a hull turns"};
    if (const Fault fault = fault_of(*patch.turn)) {
      return InputError{fmt::format("{}.{}", turn, fault->where), fault->what};
    }
  }
  if (Fault fault = fault_of_faces(patch)) return fault;
  if (Fault fault = fault_of_weights(patch)) return fault;
  return fault_of(patch.trim, patch.shape);
}

}  // namespace

bool are_weights(const std::vector<double>& weights) {
  if (weights.empty()) return true;
  // Doubles > 0 are in the order of their bits, infinity and NaNs last. Others have bits ≤ 0.
  std::int64_t least = INT64_MAX, most = INT64_MIN;
  for (const double w : weights) {
    least = std::min(least, std::bit_cast<std::int64_t>(w));
    most = std::max(most, std::bit_cast<std::int64_t>(w));
  }
  const auto top = [](std::int64_t bits) { return parts_of(std::bit_cast<double>(bits)).top(); };
  return least > 0 && is_finite(std::bit_cast<double>(most)) &&
         top(most) - top(least) <= kWeightBits;
}

std::optional<InputError> fault_of(const Query& query) {
  for (size_t p = 0; p < 2; ++p) {
    if (const Fault fault = fault_of(query.patches[p])) {
      const char* const dot = fault->where.empty() ? "" : ".";
      return InputError{fmt::format("patches[{}]{}{}", p, dot, fault->where), fault->what};
    }
  }
  if (Fault fault = fault_of_pair(query.patches)) return fault;
  for (const auto& [field, x] :
       {std::pair("t_max", query.t_max), {"separation", query.separation}}) {
    if (is_not_negative(x)) continue;
    return InputError{field, fmt::format("{} is not a finite number ≥ 0", x)};
  }
  if (!is_past_motion(query, query.t_max)) return std::nullopt;
  return InputError{"t_max",
                    fmt::format("{} is past 1, where {}", query.t_max, end_of_motion(query))};
}

bool has_ends(const Query& query) {
  return query.patches[0].has_ends() || query.patches[1].has_ends();
}

bool has_turns(const Query& query) {
  return query.patches[0].turn || query.patches[1].turn;
}

bool has_spins(const Query& query) {
  return std::ranges::any_of(query.patches, [](const MovingPatch<double>& body) {
    return body.turn && body.turn->is_spin();
  });
}

bool is_past_motion(const Query& query, double t) {
  return (has_ends(query) || has_turns(query)) && compare(t, 1) > 0;
}

std::string_view end_of_motion(const Query& query) {
  if (has_ends(query)) return "the ends of a patch are";
  return has_spins(query) ? "a spin ends" : "a turn ends";
}

bool is_rational(const Query& query) {
  return query.patches[0].is_rational() || query.patches[1].is_rational();
}

bool is_trimmed(const Query& query) {
  return !query.patches[0].trim.empty() || !query.patches[1].trim.empty();
}

std::vector<double> scaled_weights(const MovingPatch<double>& patch, int* shift) {
  std::vector<double> out;
  int exponent = 0;
  if (patch.is_rational()) {
    exponent = -std::ilogb(*std::max_element(patch.weights.begin(), patch.weights.end()));
    for (const double w : patch.weights) out.push_back(std::ldexp(w, exponent));
  }
  if (shift != nullptr) *shift = exponent;
  return out;
}

std::optional<Query> without_weights(const Query& query) {
  if (is_rational(query)) return std::nullopt;
  Query out = query;
  for (MovingPatch<double>& patch : out.patches) patch.weights.clear();
  return out;
}

void give_rounded_ends(MovingPatch<double>& patch) {
  patch.ends = patch.positions;
  for (size_t i = 0; i < patch.ends.size(); ++i) patch.ends[i] += patch.velocities[i];
  patch.velocities.clear();
}

std::optional<Query> with_velocities(const Query& query) {
  Query out = query;
  for (MovingPatch<double>& patch : out.patches) {
    if (!patch.has_ends()) continue;
    patch.velocities.assign(patch.ends.size(), Vec3<double>(0, 0, 0));
    for (size_t i = 0; i < patch.ends.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const Dyadic way = Dyadic::exact(patch.ends[i][k]) - Dyadic::exact(patch.positions[i][k]);
        const std::optional<double> velocity = way.to_double_exactly();
        if (!velocity) return std::nullopt;
        patch.velocities[i][k] = *velocity;
      }
    }
    patch.ends.clear();
  }
  return out;
}

}  // namespace ccdfuzz
