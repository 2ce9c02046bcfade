#include "case/query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "base/double_parts.hpp"
#include "bezier/trim.hpp"
#include "case/mesh.hpp"
#include "numeric/dyadic.hpp"

namespace ccdfuzz {

namespace {

/// Looks for NaN and infinities in coordinates of any bits, without a branch.
class FiniteScan {
 public:
  void add(const Vec3<double>& p) {
    TwoLanes xy;
    std::memcpy(&xy, p.data(), sizeof xy);
    xy_ |= carried(xy);
    z_ |= carried(std::bit_cast<std::uint64_t>(p[2]));
  }
  /// Nothing added was NaN or infinite.
  bool all_finite() const { return ((xy_[0] | xy_[1] | z_) >> 63) == 0; }

 private:
  using TwoLanes = std::uint64_t __attribute__((vector_size(16)));

  /// Bit 63 is set iff all bits of the exponent are: then one more carries over into the sign.
  template <class Bits>
  static Bits carried(const Bits& x) {
    constexpr std::uint64_t kMagnitude = ~(std::uint64_t{1} << 63);
    constexpr std::uint64_t kOneInExponent = std::uint64_t{1} << 52;
    return (x & kMagnitude) + kOneInExponent;
  }

  TwoLanes xy_{};
  std::uint64_t z_ = 0;
};

bool is_not_negative(double x) {
  return is_finite(x) && compare(x, 0) >= 0;
}

bool is_zero(double x) {
  return is_finite(x) && compare(x, 0) == 0;
}

bool is_hull(const MovingPatch<double>& patch) {
  return patch.shape.kind == ShapeKind::kHull;
}

bool has_valid_radius(const MovingPatch<double>& patch) {
  return is_hull(patch) ? is_not_negative(patch.radius) : is_zero(patch.radius);
}

bool has_valid_weights(const MovingPatch<double>& patch) {
  if (patch.weights.empty()) return true;
  return !is_hull(patch) && patch.weights.size() == patch.positions.size() &&
         are_weights(patch.weights);
}

Result<void> validate_weights(const MovingPatch<double>& patch, const std::string& where) {
  if (has_valid_weights(patch)) return {};
  if (is_hull(patch)) return input_error(where, "a hull has none");
  if (patch.weights.size() != patch.positions.size()) {
    return input_error(where, fmt::format("{} needs {} weights, not {}", to_text(patch.shape),
                                          patch.positions.size(), patch.weights.size()));
  }
  for (size_t i = 0; i < patch.weights.size(); ++i) {
    const double w = patch.weights[i];
    if (is_finite(w) && compare(w, 0) > 0) continue;
    return input_error(fmt::format("{}[{}]", where, i),
                       fmt::format("{} is not a finite number > 0", w));
  }
  return input_error(where, spread_of_weights());
}

Result<void> validate_shape(const Shape& shape, const std::string& where) {
  if (shape.valid()) return {};
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return input_error(where, fmt::format("a point with the degrees {} and {}, which must be 0",
                                            shape.n, shape.m));
    case ShapeKind::kCurve:
    case ShapeKind::kTriangle:
      if (shape.m == 0) break;
      return input_error(where, fmt::format("{} with a second degree {}, which must be 0",
                                            to_text(shape), shape.m));
    case ShapeKind::kTensor:
      break;
    case ShapeKind::kHull:
      return input_error(where, fmt::format("{}, {}: a hull has 1..{} points, and no second number",
                                            shape.n, shape.m, kMaxControls));
    default:
      return input_error(where, fmt::format("kind {} is none of 0 (point) to 4 (hull)",
                                            static_cast<int>(shape.kind)));
  }
  return input_error(where,
                     fmt::format("{} has a degree outside 1..{}", to_text(shape), kMaxDegree));
}

Result<void> validate_points(const Points<double>& points, const Shape& shape, size_t count,
                             const std::string& where) {
  if (points.size() != count) {
    return input_error(where, fmt::format("{} needs {} control points, not {}", to_text(shape),
                                          count, points.size()));
  }
  for (size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!is_finite(points[i][k])) {
        return input_error(fmt::format("{}[{}][{}]", where, i, k),
                           fmt::format("{} is not finite", points[i][k]));
      }
    }
  }
  return {};
}

}  // namespace

bool are_weights(const std::vector<double>& weights) {
  if (weights.empty()) return true;
  // Doubles > 0 are in the order of their bits, infinity and NaNs last. Others have bits ≤ 0.
  std::int64_t least = INT64_MAX, most = INT64_MIN;
  for (const double w : std::span(weights).first(are_equal(weights) ? 1 : weights.size())) {
    least = std::min(least, std::bit_cast<std::int64_t>(w));
    most = std::max(most, std::bit_cast<std::int64_t>(w));
  }
  const auto top = [](std::int64_t bits) { return parts_of(std::bit_cast<double>(bits)).top(); };
  return least > 0 && is_finite(std::bit_cast<double>(most)) &&
         top(most) - top(least) <= kWeightBits;
}

std::string spread_of_weights() {
  return fmt::format("has binary exponents that differ by more than {}", kWeightBits);
}

bool is_valid(const Query& query) {
  const auto is_patch = [](const MovingPatch<double>& patch) {
    if (!patch.shape.valid()) return false;
    const auto count = static_cast<size_t>(patch.shape.control_count());
    const Points<double>& moves = patch.moves();
    if (is_hull(patch)) {
      if (patch.positions.size() != count || moves.size() != 1 || patch.has_ends()) return false;
    } else if (patch.positions.size() != count || moves.size() != count) {
      return false;
    }
    if (patch.has_ends() && !patch.velocities.empty()) return false;
    if (!has_valid_radius(patch) || !has_valid_weights(patch)) return false;
    if (patch.turn && (!is_hull(patch) || fault_of(*patch.turn))) return false;
    FiniteScan scan;
    for (const Vec3<double>& p : patch.positions) scan.add(p);
    for (size_t i = 0; i < moves.size(); ++i) scan.add(moves[i]);
    return scan.all_finite() && !fault_of_faces(patch) && !fault_of(patch.trim, patch.shape);
  };
  return is_patch(query.patches[0]) && is_patch(query.patches[1]) && is_not_negative(query.t_max) &&
         is_not_negative(query.separation) && !is_past_motion(query, query.t_max) &&
         !fault_of_pair(query.patches);
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

Result<void> validate(const Query& query, const std::string& where) {
  if (is_valid(query)) return {};
  for (size_t p = 0; p < 2; ++p) {
    const MovingPatch<double>& patch = query.patches[p];
    const std::string path = fmt::format("{}patches[{}]", where, p);
    CCDFUZZ_TRY_VOID(validate_shape(patch.shape, path));
    const auto count = static_cast<size_t>(patch.shape.control_count());
    CCDFUZZ_TRY_VOID(validate_points(patch.positions, patch.shape, count, path + ".positions"));
    if (patch.has_ends() && !patch.velocities.empty()) {
      return input_error(path, "has velocities and ends, and may have one of them");
    }
    const char* const field = patch.has_ends() ? ".ends" : ".velocities";
    CCDFUZZ_TRY_VOID(
        validate_points(patch.moves(), patch.shape, is_hull(patch) ? 1 : count, path + field));
    if (is_hull(patch) && patch.has_ends()) {
      return input_error(path + ".ends", "a hull has a velocity");
    }
    if (!has_valid_radius(patch)) {
      const char* accepted = is_hull(patch) ? "a finite number ≥ 0" : "0, as of all but hulls";
      return input_error(path + ".radius", fmt::format("{} is not {}", patch.radius, accepted));
    }
    const char* const turn = patch.turn && patch.turn->is_spin() ? ".spin" : ".turn";
    if (patch.turn && !is_hull(patch)) return input_error(path + turn, "only a hull turns");
    if (const auto fault = patch.turn ? fault_of(*patch.turn) : std::nullopt) {
      return input_error(fmt::format("{}{}.{}", path, turn, fault->where), fault->what);
    }
    if (const auto fault = fault_of_faces(patch)) {
      return input_error(fmt::format("{}.{}", path, fault->where), fault->what);
    }
    CCDFUZZ_TRY_VOID(validate_weights(patch, path + ".weights"));
    if (const auto fault = fault_of(patch.trim, patch.shape)) {
      return input_error(fmt::format("{}.{}", path, fault->where), fault->what);
    }
  }
  if (const auto fault = fault_of_pair(query.patches)) {
    return input_error(where + fault->where, fault->what);
  }
  const auto refuse = [&](const char* field, double x) {
    return input_error(where + field, fmt::format("{} is not a finite number ≥ 0", x));
  };
  if (!is_not_negative(query.t_max)) return refuse("t_max", query.t_max);
  if (!is_not_negative(query.separation)) return refuse("separation", query.separation);
  if (is_past_motion(query, query.t_max)) {
    return input_error(where + "t_max",
                       fmt::format("{} is past 1, where {}", query.t_max, end_of_motion(query)));
  }
  return {};
}

}  // namespace ccdfuzz
