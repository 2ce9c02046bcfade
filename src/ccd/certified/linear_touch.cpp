#include "ccd/certified/linear_touch.hpp"

#include <cmath>

#include "ccd/certified/linear_differences.hpp"

namespace ccdfuzz::certified {

namespace {

/// Component k of a × b.
double cross_component(const Axis& a, const Axis& b, std::size_t k) {
  const std::size_t y = (k + 1) % 3, z = (k + 2) % 3;
  return a[y] * b[z] - a[z] * b[y];
}

std::size_t largest_component(const Axis& a) {
  std::size_t k = std::abs(a[1]) > std::abs(a[0]) ? 1 : 0;
  return std::abs(a[2]) > std::abs(a[k]) ? 2 : k;
}

}  // namespace

bool certainly_touch(const NormalisedQuery& query, double from, double to) {
  const Differences differences(query);
  // Corners in the order of a polygon.
  const std::array<int, 4> order =
      differences.is_face ? std::array{0, 1, 2, 2} : std::array{0, 1, 3, 2};
  const auto corners = static_cast<std::size_t>(differences.count);
  std::array<Axis, 4> before, after;
  for (std::size_t i = 0; i < corners; ++i) {
    before[i] = differences.at(order[i], from);
    after[i] = differences.at(order[i], to);
  }
  const double m = query.magnitude;
  const double of_corner = 5 * (0x1p-53 * m + query.absolute);
  if (!(of_corner < 0x1p-20 * m)) return false;
  const double of_cross = 6 * m * of_corner, of_determinant = 32 * m * m * of_corner;

  const Axis normal = cross(before[1], before[2]);
  const double first = dot_of(before[0], normal);
  const double last = dot_of(after[0], cross(after[1], after[2]));
  const bool changes = (first > of_determinant && last < -of_determinant) ||
                       (first < -of_determinant && last > of_determinant);
  if (!changes) return false;

  // All crosses of neighbours on one side in one component, by the coefficients of their
  // polynomials in Bernstein's basis, the middle one twice.
  const std::size_t k = largest_component(normal);
  const double side = std::copysign(1.0, cross_component(before[0], before[1], k));
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t j = i + 1 < corners ? i + 1 : 0;
    const double middle =
        cross_component(before[i], after[j], k) + cross_component(after[i], before[j], k);
    if (!(side * cross_component(before[i], before[j], k) > of_cross)) return false;
    if (!(side * cross_component(after[i], after[j], k) > of_cross)) return false;
    if (!(side * middle > 2 * of_cross)) return false;
  }
  return true;
}

}  // namespace ccdfuzz::certified
