#include "ccd/rational/axis.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz::exact_ccd {

std::optional<IntegerAxis> round_to_axis(const Vec3<double>& direction, int bits) {
  const double largest =
      std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
  constexpr double kLeast = 0x1p-900;  // smaller only where the direction is lost to rounding
  if (!(largest >= kLeast) || !std::isfinite(largest)) return std::nullopt;
  // Off by the rounding of the quotient, far less than ½ in any component: |x| ≤ 2^bits·(1 + 2u).
  const double scale = static_cast<double>(std::int32_t{1} << bits) / largest;
  IntegerAxis axis;
  for (size_t k = 0; k < 3; ++k) {
    const double x = direction[static_cast<Eigen::Index>(k)] * scale;
    axis.l[k] = static_cast<std::int32_t>(x + std::copysign(0.5, x));
  }
  return axis;
}

}  // namespace ccdfuzz::exact_ccd
