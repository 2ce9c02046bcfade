#include "generators/tangent_cone.hpp"

#include <algorithm>

#include "generators/differential.hpp"
#include "generators/shaped/features.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {

TangentCone tangent_cone(const Points<Dyadic>& points, const Barycentric& x) {
  const auto along = [&](const Barycentric& d) { return slope(points, x, d); };
  switch (feature_at(x)) {
    case Feature::kFace:
      return {{along(towards(corner_point(2), corner_point(0))),
               along(towards(corner_point(2), corner_point(1)))},
              {}};
    case Feature::kEdge: {
      const int k = corner_opposite(x);
      const Barycentric a = corner_point((k + 1) % 3), b = corner_point((k + 2) % 3);
      return {{along(towards(a, b))}, {along(towards(x, corner_point(k)))}};
    }
    case Feature::kCorner: {
      const int k = corner_of(x);
      return {{},
              {along(towards(x, corner_point((k + 1) % 3))),
               along(towards(x, corner_point((k + 2) % 3)))}};
    }
  }
  return {};
}

// The vectors N with N·a ≥ 0 for all a form a convex cone. If the a span space, it is pointed. Then
// each N is a sum of extreme rays, and each of those is perpendicular to two independent a. So the
// sum of all rays ±(a × b) in the cone is in its relative interior. There N·a is 0 only for those a
// for which it is 0 on all of the cone.
std::optional<Vec3<Dyadic>> common_normal(const std::vector<Vec3<Dyadic>>& above,
                                          const std::vector<Vec3<Dyadic>>& level) {
  std::vector<Vec3<Dyadic>> all = above;
  for (const Vec3<Dyadic>& t : level) {
    all.push_back(t);
    all.push_back(-t);
  }
  const auto in_cone = [&all](const Vec3<Dyadic>& ray) {
    return std::all_of(all.begin(), all.end(),
                       [&](const Vec3<Dyadic>& a) { return dot(ray, a).sign() >= 0; });
  };
  Vec3<Dyadic> sum = {Dyadic(), Dyadic(), Dyadic()};
  for (size_t i = 0; i < all.size(); ++i) {
    for (size_t j = i + 1; j < all.size(); ++j) {
      const Vec3<Dyadic> ray = cross(all[i], all[j]);
      if (in_cone(ray)) sum += ray;
      if (in_cone(-ray)) sum -= ray;
    }
  }
  const bool strict = std::all_of(above.begin(), above.end(),
                                  [&](const Vec3<Dyadic>& a) { return dot(sum, a).sign() > 0; });
  const bool nonzero = sum[0].sign() != 0 || sum[1].sign() != 0 || sum[2].sign() != 0;
  if (!strict || !nonzero) return std::nullopt;
  return sum;
}

std::optional<Vec3<Dyadic>> separating_normal(const TangentCone& cone_1, const TangentCone& cone_2,
                                              std::vector<Vec3<Dyadic>> above) {
  above.insert(above.end(), cone_1.sides.begin(), cone_1.sides.end());
  for (const Vec3<Dyadic>& side : cone_2.sides) above.push_back(-side);
  std::vector<Vec3<Dyadic>> level = cone_1.lines;
  level.insert(level.end(), cone_2.lines.begin(), cone_2.lines.end());
  return common_normal(above, level);
}

}  // namespace ccdfuzz
