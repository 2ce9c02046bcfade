#include "case/query.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>

#include "base/double_parts.hpp"

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

bool is_time(double t) {
  return is_finite(t) && compare(t, 0) >= 0;
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
    default:
      return input_error(where, fmt::format("kind {} is none of 0 (point) to 3 (tensor)",
                                            static_cast<int>(shape.kind)));
  }
  return input_error(where,
                     fmt::format("{} has a degree outside 1..{}", to_text(shape), kMaxDegree));
}

Result<void> validate_points(const Points<double>& points, const Shape& shape,
                             const std::string& where) {
  if (static_cast<int>(points.size()) != shape.control_count()) {
    return input_error(where, fmt::format("{} needs {} control points, not {}", to_text(shape),
                                          shape.control_count(), points.size()));
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

bool is_valid(const Query& query) {
  const auto is_patch = [](const MovingPatch<double>& patch) {
    if (!patch.shape.valid()) return false;
    const auto count = static_cast<size_t>(patch.shape.control_count());
    if (patch.positions.size() != count || patch.velocities.size() != count) return false;
    FiniteScan scan;
    for (size_t i = 0; i < count; ++i) {
      scan.add(patch.positions[i]);
      scan.add(patch.velocities[i]);
    }
    return scan.all_finite();
  };
  return is_patch(query.patches[0]) && is_patch(query.patches[1]) && is_time(query.t_max);
}

Result<void> validate(const Query& query, const std::string& where) {
  if (is_valid(query)) return {};
  for (size_t p = 0; p < 2; ++p) {
    const MovingPatch<double>& patch = query.patches[p];
    const std::string path = fmt::format("{}patches[{}]", where, p);
    if (auto r = validate_shape(patch.shape, path); !r) return r;
    if (auto r = validate_points(patch.positions, patch.shape, path + ".positions"); !r) return r;
    if (auto r = validate_points(patch.velocities, patch.shape, path + ".velocities"); !r) return r;
  }
  if (!is_time(query.t_max)) {
    return input_error(where + "t_max", fmt::format("{} is not a finite number ≥ 0", query.t_max));
  }
  return {};
}

}  // namespace ccdfuzz
