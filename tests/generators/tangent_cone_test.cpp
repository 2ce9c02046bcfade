#include "generators/tangent_cone.hpp"

#include <gtest/gtest.h>

#include "bezier/blossom.hpp"
#include "generators/draw/draw.hpp"
#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

Vec3<Dyadic> small_vector(Draw& random, int bound) {
  Vec3<Dyadic> v;
  for (int k = 0; k < 3; ++k) v[k] = Dyadic(static_cast<int>(random.integer(-bound, bound)));
  return v;
}

bool is_common_normal(const Vec3<Dyadic>& n, const std::vector<Vec3<Dyadic>>& above,
                      const std::vector<Vec3<Dyadic>>& level) {
  for (const Vec3<Dyadic>& a : above) {
    if (dot(n, a).sign() <= 0) return false;
  }
  for (const Vec3<Dyadic>& t : level) {
    if (dot(n, t).sign() != 0) return false;
  }
  return true;
}

/// Looks for one among all integer vectors up to 4.
bool one_exists(const std::vector<Vec3<Dyadic>>& above, const std::vector<Vec3<Dyadic>>& level) {
  constexpr int kBound = 4;
  for (int x = -kBound; x <= kBound; ++x) {
    for (int y = -kBound; y <= kBound; ++y) {
      for (int z = -kBound; z <= kBound; ++z) {
        if (is_common_normal({Dyadic(x), Dyadic(y), Dyadic(z)}, above, level)) return true;
      }
    }
  }
  return false;
}

TEST(TangentCone, ACommonNormalIsRightAndIsFoundIfThereIsOne) {
  int found = 0, missing = 0;
  for (std::uint64_t key = 0; key < 600; ++key) {
    Draw random{Random(key)};
    // Shapes of EE, VF, VE and VV: sides and lines of both patches, and the approach.
    constexpr std::array<std::array<int, 2>, 4> kCounts = {{{3, 2}, {3, 2}, {4, 1}, {5, 0}}};
    const auto [above_count, level_count] = kCounts[key % 4];
    std::vector<Vec3<Dyadic>> above, level;
    for (int i = 0; i < above_count; ++i) above.push_back(small_vector(random, 2));
    for (int i = 0; i < level_count; ++i) level.push_back(small_vector(random, 2));
    const auto normal = common_normal(above, level);
    if (normal) {
      EXPECT_TRUE(is_common_normal(*normal, above, level)) << "key " << key;
      ++found;
    } else {
      std::array<Vec3<Dyadic>, 3> first;
      for (int i = 0; i < 3; ++i) {
        first[static_cast<size_t>(i)] = i < level_count ? level[i] : above[i - level_count];
      }
      // The promise is for vectors that span space.
      if (dot(first[0], cross(first[1], first[2])).sign() != 0) {
        EXPECT_FALSE(one_exists(above, level)) << "key " << key;
        ++missing;
      }
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(missing, 100);
}

TEST(TangentCone, HasTheLinesAndSidesOfItsFeature) {
  Draw random{Random(1)};
  Points<Dyadic> points;
  for (size_t i = 0; i < 6; ++i) points.push_back(random.vector(12, -8));
  const auto sizes = [&](Feature feature) {
    const TangentCone cone = tangent_cone(points, prescribe_in_parent(feature, random));
    return std::array{cone.lines.size(), cone.sides.size()};
  };
  EXPECT_EQ(sizes(Feature::kFace), (std::array<size_t, 2>{2, 0}));
  EXPECT_EQ(sizes(Feature::kEdge), (std::array<size_t, 2>{1, 1}));
  EXPECT_EQ(sizes(Feature::kCorner), (std::array<size_t, 2>{0, 2}));
}

// The sides point into the patch and the lines along it: a short step stays near the cone.
TEST(TangentCone, SidesAreTheDerivativesIntoThePatch) {
  Draw random{Random(2)};
  Points<Dyadic> points;
  for (size_t i = 0; i < 6; ++i) points.push_back(random.vector(12, -8));
  const Dyadic zero, half(1, -1), step(1, -20);
  const Uv<Dyadic> at = {half, half}, inward = {half - step.scaled(-1), half - step.scaled(-1)};
  const TangentCone edge = tangent_cone(points, {half, half, zero});
  // S(x + s·d) − S(x) = s·side + s²·bend, and the bend is below 2^7.
  const Vec3<Dyadic> moved =
      evaluate<Dyadic>(kQuadratic, points, inward) - evaluate<Dyadic>(kQuadratic, points, at);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LE(abs(moved[k] - edge.sides[0][k] * step), step * step * Dyadic(128));
  }
}

}  // namespace
}  // namespace ccdfuzz
