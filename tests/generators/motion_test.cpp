#include "generators/paper.hpp"

#include <gtest/gtest.h>

#include "generators/prescribe.hpp"
#include "numeric/products.hpp"

namespace ccdfuzz {
namespace {

TEST(Motion, ContactPointsOfVertexVertexMoveAnyWay) {
  constexpr ContactClass kContact = ContactClass::kVV;
  constexpr int kMotions = 50;
  int approaching = 0;
  for (std::uint64_t key = 0; key < kMotions; ++key) {
    Draw random{Random(key)};
    const Vec3<Dyadic> normal = random.vector(4, 0);
    PrescribedContact prescribed{Dyadic(1), {}};
    std::array<Points<Dyadic>, 2> points;
    for (size_t s = 0; s < 2; ++s) {
      const Barycentric x = prescribe_in_parent(features_of(kContact)[s], random);
      prescribed.x[s] = choose_local_patch(x, random).x;
      for (size_t i = 0; i < 6; ++i) points[s].push_back(random.vector(46, -41));
    }
    const auto patches = set_in_motion(points, prescribed, normal, kContact, random);
    approaching += dot(normal, point_at(patches[0].velocities, prescribed.x[0])).sign() < 0;
  }
  EXPECT_GT(approaching, kMotions / 5);
  EXPECT_LT(approaching, 4 * kMotions / 5);
}

}  // namespace
}  // namespace ccdfuzz
