#include "generators/moving_plane.hpp"

#include <algorithm>

#include "certify/checker/copositive.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

namespace {

std::array<Dyadic, 6> heights_of(const Points<Dyadic>& points, const Vec3<Dyadic>& normal) {
  std::array<Dyadic, 6> heights;
  for (size_t i = 0; i < 6; ++i) heights[i] = dot<Dyadic>(normal, points[i]);
  return heights;
}

}  // namespace

bool moving_plane_separates(const Scene& scene, const Vec3<Dyadic>& normal) {
  const std::array<Dyadic, 6> rate_1 = heights_of(scene.patches[0].velocities, normal);
  const std::array<Dyadic, 6> rate_2 = heights_of(scene.patches[1].velocities, normal);
  if (*std::max_element(rate_1.begin(), rate_1.end()) >=
      *std::min_element(rate_2.begin(), rate_2.end())) {
    return false;
  }
  for (size_t s = 0; s < 2; ++s) {
    const Points<Dyadic> points = scene.patches[s].at(scene.contact.t);
    const Vec3<Dyadic> contact = weighted_sum(bernstein_weights(scene.contact.x[s]), points);
    const Dyadic origin = dot<Dyadic>(normal, contact);
    std::array<Dyadic, 6> heights = heights_of(points, normal);
    for (Dyadic& h : heights) h = s == 0 ? h - origin : origin - h;
    if (!nonnegative_on_triangle(heights)) return false;
  }
  return true;
}

MovingPlane moving_plane(const Scene& scene, const Vec3<Dyadic>& normal) {
  const Dyadic& t = scene.contact.t;
  const Vec3<Dyadic> contact =
      weighted_sum(bernstein_weights(scene.contact.x[0]), scene.patches[0].at(t));
  return {t.rational(),
          {normal[0].rational(), normal[1].rational(), normal[2].rational()},
          dot<Dyadic>(normal, contact).rational()};
}

}  // namespace ccdfuzz
