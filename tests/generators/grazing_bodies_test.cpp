// Bodies that touch without depth, and bodies in the plane z = 0.
#include <gtest/gtest.h>

#include "case/scale.hpp"
#include "certify/checker/check_case.hpp"
#include "certify/oracle/body_depth.hpp"
#include "generators/draw/draw.hpp"
#include "generators/generate.hpp"

namespace ccdfuzz {
namespace {

Case made(Family family, ContactClass contact, std::uint64_t index, bool plane = false,
          std::uint64_t seed = 0) {
  GeneratorOptions options{.contact = contact, .family = family, .plane = plane, .seed = seed};
  Case value = generate(options, index).value;
  EXPECT_TRUE(check_case(value)) << name_of(contact) << ' ' << index;
  EXPECT_TRUE(is_binary32(value.query));
  EXPECT_EQ(is_in_plane(value.query), plane);
  return value;
}

constexpr std::array kPlaneClasses = {ContactClass::kEE, ContactClass::kVE, ContactClass::kVV};

TEST(GrazingBodies, TouchAfterTheStartAndNeverDeeperInAPlaneToo) {
  for (std::uint64_t index = 0; index < 4; ++index) {
    for (const ContactClass contact : kPlaneClasses) {
      const Case value = made(Family::kBodiesGrazing, contact, index, true);
      EXPECT_EQ(value.truth.collides, true);
      EXPECT_GT(value.truth.witness->t, 0);
      EXPECT_EQ(depth_until(value.query, value.query.t_max, true), 0.0);
    }
  }
}

TEST(GrazingBodies, HaveNoFrontInThePlaneOfTheirMotion) {
  EXPECT_FALSE(is_made(Family::kMeshGrazingOneSided, ContactClass::kFF, CaseKind::kRP));
  EXPECT_FALSE(is_made(Family::kMeshGrazingOneSided, ContactClass::kVF, CaseKind::kRN));
  EXPECT_FALSE(is_made(Family::kMeshGrazing, ContactClass::kVF, CaseKind::kNMN));
}

TEST(GrazingBodies, ThatDoNotMoveAgainstEachOtherAreThrownAway) {
  made(Family::kMeshGrazing, ContactClass::kFF, 53, false, 3);
}

TEST(Bodies, OfDoublesAreFarAwaySomeTouchAtTheStartAndTheirTruthHolds) {
  GeneratorOptions options{.family = Family::kBodies};
  options.binary64 = options.at_start = true;
  double largest = 0;
  int at_start = 0;
  for (std::uint64_t index = 0; index < 200; ++index) {
    options.contact = kContactClasses[index % kContactClasses.size()];
    const Case value = generate(options, index).value;
    EXPECT_TRUE(check_case(value)) << name_of(options.contact) << ' ' << index;
    largest = std::max(largest, largest_coordinate(value.query));
    at_start += value.truth.witness->t == 0 ? 1 : 0;
  }
  EXPECT_GT(largest, 0x1p36);
  EXPECT_GT(at_start, 10);
}

// Number 693 is 2^-17 large and 9 from the origin.
TEST(Meshes, AreMadeWhereTheirStepsAreShorterThanThoseBetweenFloats) {
  GeneratorOptions options;
  constexpr std::array kKinds = {CaseKind::kRP, CaseKind::kRN, CaseKind::kNMN};
  constexpr std::array kFamilies = {Family::kMesh, Family::kMeshOneSided};
  for (std::uint64_t i = 600; i < 700; ++i) {
    Draw draw = Draw::mostly_small(Random::keyed({20261128, i}));
    options.kind = draw.pick(kKinds);
    options.contact = draw.pick(kContactClasses);
    options.family = kFamilies[draw.below(2)];
    const Case value = generate(options, draw).value;
    EXPECT_TRUE(check_case(value)) << i;
  }
}

TEST(BodiesInAPlane, LieAndMoveInItAndSpinAboutItsNormal) {
  for (const ContactClass contact : kPlaneClasses) {
    for (std::uint64_t index = 0; index < 4; ++index) made(Family::kBodies, contact, index, true);
    EXPECT_TRUE(has_spins(made(Family::kSpinning, contact, 0, true).query));
  }
}

}  // namespace
}  // namespace ccdfuzz
