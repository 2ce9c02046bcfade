#include "fuzz/mutator/small_vector.hpp"

#include <cmath>

#include "case/scale.hpp"

namespace ccdfuzz {

int size_exponent(const Points<double>& points) {
  int exponent = 0;
  std::frexp(largest_coordinate(points), &exponent);
  return exponent;
}

Vec3<Dyadic> small_vector(const Points<double>& points, Draw& draw) {
  constexpr int kBits = 3, kPrecision = 53;
  const long unit = size_exponent(points) - kBits - static_cast<long>(draw.below(kPrecision));
  const bool along_an_axis = draw.coin();
  const std::uint64_t axis = draw.below(3);
  Vec3<Dyadic> v = draw.vector(kBits, unit);
  for (int k = 0; k < 3 && along_an_axis; ++k) {
    if (static_cast<std::uint64_t>(k) != axis) v[k] = Dyadic();
  }
  return v;
}

}  // namespace ccdfuzz
