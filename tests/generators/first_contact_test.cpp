#include "generators/first_contact.hpp"

#include <gtest/gtest.h>

#include "generators/finalize.hpp"
#include "generators/paper.hpp"

namespace ccdfuzz {
namespace {

const Dyadic kUntil = Dyadic(1) - Dyadic(1, -20);

bool proven(const Scene& scene, bool by_search = false) {
  const std::optional<Query> query = to_query(scene.patches, 1);
  if (!query) return false;
  Case made;
  made.query = *query;
  return prove_first_contact(scene, made, kUntil, false, GeneratorOptions().proof_pops) &&
         made.truth.clear_until == kUntil.rational() && !(by_search && made.truth.clearance);
}

// Reversed in time the patches are in each other before t*, right up to it. (Not so VE and VV: a
// corner may pass by an edge or a corner.)
TEST(FirstContact, IsNotProvenWhereThePatchesComeOutOfEachOther) {
  for (const ContactClass contact :
       {ContactClass::kFF, ContactClass::kEF, ContactClass::kEE, ContactClass::kVF}) {
    int reversed = 0;
    for (std::uint64_t key = 0; key < 100 && reversed < 10; ++key) {
      Draw random{Random(key)};
      std::optional<Scene> scene = paper_scene(contact, false, random);
      if (!scene || !proven(*scene)) continue;
      for (MovingPatch<Dyadic>& patch : scene->patches) {
        patch.positions = patch.at(scene->contact.t);
        for (size_t i = 0; i < 6; ++i) {
          patch.velocities[i] = -patch.velocities[i];
          patch.positions[i] -= patch.velocities[i] * scene->contact.t;
        }
      }
      if (!to_query(scene->patches, 1)) continue;
      ++reversed;
      EXPECT_FALSE(proven(*scene)) << name_of(contact) << " key " << key;
    }
    EXPECT_EQ(reversed, 10) << name_of(contact);
  }
}

/// Patch 1 falls on the large flat patch 2, its corner w first. Its corner u has this speed, and is
/// at height 1 above the plane at t*.
Scene corner_on_plate(int speed_of_u) {
  constexpr std::array<std::array<int, 3>, 3> kCorner = {{{2, 0, 1}, {0, 2, 1}, {0, 0, 0}}};
  constexpr std::array<std::array<int, 2>, 3> kPlate = {{{24, -8}, {-8, 24}, {-8, -8}}};
  Scene scene;
  scene.contact = {
      Dyadic(1),
      {{{Dyadic(0), Dyadic(0), Dyadic(1)}, {Dyadic(1, -2), Dyadic(1, -2), Dyadic(1, -1)}}}};
  scene.normal = {Dyadic(0), Dyadic(0), Dyadic(1)};
  for (MovingPatch<Dyadic>& patch : scene.patches) {
    patch = {kQuadratic, Points<Dyadic>(6, Vec3<Dyadic>::Zero()),
             Points<Dyadic>(6, Vec3<Dyadic>::Zero())};
  }
  for (size_t i = 0; i < 6; ++i) {
    const auto [a, b] = kCornerPairs[i];
    const int speed = i == control_of(0, 0) ? speed_of_u : -1;
    scene.patches[0].velocities[i][2] = Dyadic(speed);
    for (int k = 0; k < 3; ++k) {
      scene.patches[0].positions[i][k] = Dyadic(kCorner[a][k] + kCorner[b][k], -1);
    }
    scene.patches[0].positions[i][2] -= Dyadic(speed);
    for (int k = 0; k < 2; ++k) {
      scene.patches[1].positions[i][k] = Dyadic(kPlate[a][k] + kPlate[b][k], -1);
    }
  }
  return scene;
}

// No local argument sees it: the corner u swings up through the plate from below.
TEST(FirstContact, IsNotProvenWhereAnotherPartTouchesBefore) {
  EXPECT_TRUE(proven(corner_on_plate(-1)));
  EXPECT_FALSE(proven(corner_on_plate(4)));
}

// Patches that bend the same way, such as a bowl inside a bowl, are separated by no plane.
TEST(FirstContact, IsProvenBySearchWhereNoPlaneDoesIt) {
  int by_search = 0;
  for (std::uint64_t key = 0; key < 200 && by_search < 3; ++key) {
    Draw random{Random(key)};
    const std::optional<Scene> scene = paper_scene(ContactClass::kEF, false, random);
    if (!scene) continue;
    by_search += proven(*scene, true);
  }
  EXPECT_EQ(by_search, 3);
}

}  // namespace
}  // namespace ccdfuzz
