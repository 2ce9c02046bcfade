#include "generators/moving_plane.hpp"

#include <gtest/gtest.h>

namespace ccdfuzz {
namespace {

const Vec3<Dyadic> kUp = {Dyadic(0), Dyadic(0), Dyadic(1)};

/// Two equal flat triangles in the plane z = 0 that touch at their corners w. Patch 1 moves down
/// and patch 2 up, each with speed 1.
Scene two_flat_triangles() {
  Scene scene;
  scene.contact.t = Dyadic(1);
  for (size_t s = 0; s < 2; ++s) {
    scene.contact.x[s] = {Dyadic(0), Dyadic(0), Dyadic(1)};
    MovingPatch<Dyadic>& patch = scene.patches[s];
    patch = {kQuadratic, Points<Dyadic>(6), Points<Dyadic>(6)};
    for (size_t i = 0; i < 6; ++i) {
      const auto [a, b] = kCornerPairs[i];
      const Dyadic speed(s == 0 ? -1 : 1);
      patch.positions[i] = {Dyadic((a == 0) + (b == 0)), Dyadic((a == 1) + (b == 1)), -speed};
      patch.velocities[i] = {Dyadic(0), Dyadic(0), speed};
    }
  }
  return scene;
}

TEST(MovingPlane, SeparatesPatchesThatCloseInOnEachOther) {
  EXPECT_TRUE(moving_plane_separates(two_flat_triangles(), kUp));
}

TEST(MovingPlane, RefusesTheOppositeNormal) {
  EXPECT_FALSE(moving_plane_separates(two_flat_triangles(), -kUp));
}

TEST(MovingPlane, RefusesAControlPointThatOvertakesThePlane) {
  for (size_t s = 0; s < 2; ++s) {
    for (size_t i = 0; i < 6; ++i) {
      Scene scene = two_flat_triangles();
      // Position at t* unchanged: only the velocity speaks against the plane.
      const Dyadic change(s == 0 ? 2 : -2);
      scene.patches[s].velocities[i][2] += change;
      scene.patches[s].positions[i][2] -= change;
      EXPECT_FALSE(moving_plane_separates(scene, kUp)) << "patch " << s << " control " << i;
    }
  }
}

TEST(MovingPlane, RefusesEqualVelocitiesWhichLeaveThePatchesInTouchBefore) {
  Scene scene = two_flat_triangles();
  for (size_t i = 0; i < 6; ++i) {
    for (MovingPatch<Dyadic>& patch : scene.patches) {
      patch.positions[i][2] = Dyadic(0);
      patch.velocities[i][2] = Dyadic(0);
    }
  }
  EXPECT_FALSE(moving_plane_separates(scene, kUp));
}

TEST(MovingPlane, RefusesAPatchThatReachesThroughThePlane) {
  for (size_t s = 0; s < 2; ++s) {
    for (size_t i = 1; i < 6; ++i) {
      Scene scene = two_flat_triangles();
      scene.patches[s].positions[i][2] += Dyadic(s == 0 ? -1 : 1, -60);
      EXPECT_FALSE(moving_plane_separates(scene, kUp)) << "patch " << s << " control " << i;
    }
  }
}

}  // namespace
}  // namespace ccdfuzz
