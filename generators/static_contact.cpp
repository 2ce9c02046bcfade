#include "generators/paper.hpp"
#include "generators/shaped/features.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

constexpr int kCoordinateBits = 12;
constexpr long kCoordinateUnit = -8;
constexpr int kMaxNormalExponent = 2;

/// The plane n·p = level, every component of n zero or a power of two (Appendix E.3).
struct Plane {
  Vec3<Dyadic> normal;
  Dyadic level;
  int largest = 0;  ///< component of the normal
};

Plane random_plane(Draw& draw) {
  Plane plane;
  plane.normal = draw.until(
      [&] {
        Vec3<Dyadic> normal;
        for (int k = 0; k < 3; ++k) {
          const int sign = draw.integer(-1, 1);
          normal[k] = Dyadic(sign, draw.integer(0, kMaxNormalExponent));
        }
        return normal;
      },
      [](const Vec3<Dyadic>& n) { return n != Vec3<Dyadic>(); });
  plane.largest = largest_component(plane.normal);
  plane.level = dot(plane.normal, draw.vector(kCoordinateBits, kCoordinateUnit));
  return plane;
}

Points<Dyadic> random_points(Draw& draw) {
  Points<Dyadic> points;
  for (size_t i = 0; i < 6; ++i) points.push_back(draw.vector(kCoordinateBits, kCoordinateUnit));
  return points;
}

/// x / y for y = ±2^k.
Dyadic over_power_of_two(const Dyadic& x, const Dyadic& y) {
  CCDFUZZ_VERIFY(abs(y.mantissa()) == 1);
  return (y.sign() < 0 ? -x : x).scaled(-y.exponent());
}

/// Puts the last de Casteljau points of x into the plane, by one coordinate of each corner control
/// whose corner takes part in x.
void make_tangent(Points<Dyadic>& points, const Barycentric& x, const Plane& plane) {
  for (int a = 0; a < 3; ++a) {
    if (x[a].sign() == 0) continue;
    Vec3<Dyadic>& corner = points[control_of(a, a)];
    corner[plane.largest] = Dyadic();
    Dyadic excess = -plane.level;
    for (int b = 0; b < 3; ++b) excess += x[b] * dot(plane.normal, points[control_of(a, b)]);
    corner[plane.largest] =
        -over_power_of_two(over_power_of_two(excess, x[a]), plane.normal[plane.largest]);
  }
}

}  // namespace

std::array<Points<Dyadic>, 2> static_contact(const std::array<Barycentric, 2>& x, Draw& draw) {
  const Plane plane = random_plane(draw);
  std::array<Points<Dyadic>, 2> points;
  for (Points<Dyadic>& p : points) p = random_points(draw);
  if (feature_at(x[1]) == Feature::kFace && feature_at(x[0]) != Feature::kCorner) {
    for (size_t s = 0; s < 2; ++s) make_tangent(points[s], x[s], plane);
  }
  const Vec3<Dyadic> gap = point_at(points[0], x[0]) - point_at(points[1], x[1]);
  for (Vec3<Dyadic>& p : points[1]) p += gap;
  return points;
}

}  // namespace ccdfuzz
