#include "ccd/rational/axis.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz::exact_ccd {

std::optional<Axis> round_to_axis(const Vec3<double>& direction, int bits) {
  const double largest =
      std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  const auto scale = static_cast<double>(std::int32_t{1} << bits);
  Axis axis;
  for (size_t k = 0; k < 3; ++k) {
    const double x = direction[static_cast<Eigen::Index>(k)] / largest * scale;
    axis.l[k] = static_cast<std::int32_t>(x + std::copysign(0.5, x));
  }
  return axis;
}

}  // namespace ccdfuzz::exact_ccd
