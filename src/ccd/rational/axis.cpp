#include "ccd/rational/axis.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz::exact_ccd {

std::optional<Axis> round_to_axis(const Vec3<double>& direction, int bits) {
  const double largest =
      std::max({std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2])});
  if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
  int exponent = 0;
  std::frexp(largest, &exponent);  // 2^(exponent−1) ≤ largest < 2^exponent
  Axis axis;
  for (size_t k = 0; k < 3; ++k) {
    const double x = std::ldexp(direction[static_cast<Eigen::Index>(k)], bits - exponent);
    axis.l[k] = static_cast<std::int32_t>(x + std::copysign(0.5, x));  // |x| < 2^bits: to nearest
  }
  return axis;
}

}  // namespace ccdfuzz::exact_ccd
