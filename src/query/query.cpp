#include "query/query.hpp"

#include <fmt/format.h>

#include "numeric/double_parts.hpp"

namespace ccdfuzz {

namespace {

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

Result<void> validate(const Query& query, const std::string& where) {
  for (size_t p = 0; p < 2; ++p) {
    const MovingPatch<double>& patch = query.patches[p];
    const std::string path = fmt::format("{}patches[{}]", where, p);
    if (!patch.shape.valid()) {
      return input_error(
          path, fmt::format("{} has a degree outside 1..{}", to_text(patch.shape), kMaxDegree));
    }
    if (auto r = validate_points(patch.positions, patch.shape, path + ".positions"); !r) return r;
    if (auto r = validate_points(patch.velocities, patch.shape, path + ".velocities"); !r) return r;
  }
  if (!is_finite(query.t_max) || compare(query.t_max, 0) < 0) {
    return input_error(where + "t_max", fmt::format("{} is not a finite number ≥ 0", query.t_max));
  }
  return {};
}

}  // namespace ccdfuzz
