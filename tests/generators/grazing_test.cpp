#include "generators/grazing.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ccd/rational/proves_clear.hpp"
#include "certify/checker/check_witness.hpp"
#include "generators/generate.hpp"
#include "generators/prescribe.hpp"
#include "generators/static_check.hpp"
#include "generators/static_contact.hpp"
#include "numeric/products.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

struct Grazing {
  std::array<Points<Dyadic>, 2> points;
  PrescribedContact contact;
  GrazingPlane plane;
  std::array<MovingPatch<Dyadic>, 2> patches;
};

/// Some near-hits of every class, in the sizes of the paper's construction.
template <class Check>
void for_each_grazing(const Check& check) {
  for (const ContactClass contact : kContactClasses) {
    int made = 0;
    for (std::uint64_t key = 0; made < 8; ++key) {
      ASSERT_LT(key, 400U) << name_of(contact);
      SCOPED_TRACE(fmt::format("{} key {}", name_of(contact), key));
      Draw random{Random(key)};
      Grazing g;
      g.contact.t = Dyadic(1);
      const auto features = features_of(contact);
      for (size_t s = 0; s < 2; ++s) g.contact.x[s] = prescribe_in_parent(features[s], random);
      g.points = static_contact(g.contact.x, random);
      const auto normal = static_check(g.points, g.contact.x);
      if (!normal) continue;
      const auto plane = grazing_plane(g.points, g.contact.x, *normal, random);
      if (!plane) continue;
      g.plane = *plane;
      g.patches = set_grazing(g.points, g.contact, g.plane, random);
      ++made;
      check(g);
    }
  }
}

TEST(Grazing, BringsThePatchesWhereTheyAreToBeAtTheContactTime) {
  for_each_grazing([](const Grazing& g) {
    for (size_t s = 0; s < 2; ++s) EXPECT_EQ(g.patches[s].at(g.contact.t), g.points[s]);
  });
}

TEST(Grazing, ContactPointsMoveRelativeToEachOtherAndWithinThePlane) {
  for_each_grazing([](const Grazing& g) {
    std::array<Vec3<Dyadic>, 2> speed;
    for (size_t s = 0; s < 2; ++s) {
      speed[s] = weighted_sum(bernstein_weights(g.contact.x[s]), g.patches[s].velocities);
    }
    EXPECT_NE(speed[0], speed[1]);
    EXPECT_EQ(dot(g.plane.normal, Vec3<Dyadic>(speed[1] - speed[0])).sign(), 0);
    for (const Vec3<Dyadic>& t : g.plane.tangent) {
      EXPECT_EQ(dot(g.plane.normal, t).sign(), 0);
    }
  });
}

// The normal parts of the velocities are those of an approach, or equal: no patch reaches through
// the plane before the contact because of its deformation.
TEST(Grazing, NoControlPointCrossesThePlaneByItsDeformation) {
  for_each_grazing([](const Grazing& g) {
    const Vec3<Dyadic> at_contact =
        weighted_sum(bernstein_weights(g.contact.x[0]), g.patches[0].velocities);
    const Dyadic rate = dot(g.plane.normal, at_contact);
    for (const Vec3<Dyadic>& v : g.patches[0].velocities) EXPECT_LE(dot(g.plane.normal, v), rate);
    for (const Vec3<Dyadic>& v : g.patches[1].velocities) EXPECT_GE(dot(g.plane.normal, v), rate);
  });
}

TEST(Grazing, PartMovesPatch2AwayFromPatch1) {
  Scene scene;
  scene.normal = {Dyadic(1), Dyadic(-3), Dyadic(2)};
  for (auto& patch : scene.patches) {
    patch.positions.assign(6, Vec3<Dyadic>(Dyadic(0), Dyadic(0), Dyadic(0)));
  }
  part(scene, -5);
  for (const Vec3<Dyadic>& p : scene.patches[0].positions)
    EXPECT_EQ(dot(scene.normal, p).sign(), 0);
  for (const Vec3<Dyadic>& p : scene.patches[1].positions) {
    EXPECT_EQ(dot(scene.normal, p), -Dyadic(3, -5));
  }
}

TEST(Grazing, NearHitsTouchAndNearMissesDoNot) {
  size_t next = 0;
  for (const Construction construction : kConstructions) {
    for (const ContactClass contact : kContactClasses) {
      if (++next % std::min<size_t>(kOneIn, 4) != 0) continue;
      GeneratorOptions options;
      options.construction = construction;
      options.contact = contact;
      options.kind = CaseKind::kNHP;
      SCOPED_TRACE(fmt::format("{} {}", name_of(construction), name_of(contact)));
      const Case hit = generate(options, 0).value;
      EXPECT_EQ(hit.truth.collides, true);
      ASSERT_TRUE(hit.truth.witness);
      EXPECT_TRUE(check_witness(hit.query, *hit.truth.witness));
      EXPECT_TRUE(proves_clear(hit.query, *hit.truth.clear_until));
      EXPECT_EQ(hit.origin.kind, "NHP");
      options.kind = CaseKind::kNMN;
      const Case miss = generate(options, 0).value;
      EXPECT_EQ(miss.truth.collides, false);
      EXPECT_EQ(miss.truth.clear_until, exact(miss.query.t_max));
      EXPECT_TRUE(proves_clear(miss.query, exact(miss.query.t_max)));
      EXPECT_EQ(miss.query.t_max, hit.query.t_max);
    }
  }
}

// What a search of few pops does not prove is thrown away, and no claim is made without a proof.
TEST(Grazing, FewPopsThrowAwayMore) {
  GeneratorOptions options;
  options.contact = ContactClass::kFF;
  options.construction = Construction::kOneSided;
  options.kind = CaseKind::kNHP;
  constexpr std::uint64_t kPops = 1000;
  DiscardCounts many, few;
  for (std::uint64_t i = 0; i < 6; ++i) {
    options.proof_pops = GeneratorOptions().proof_pops;
    many += generate(options, i).discards;
    options.proof_pops = kPops;
    const Generated made = generate(options, i);
    few += made.discards;
    EXPECT_TRUE(proves_clear(made.value.query, *made.value.truth.clear_until, {.pops = kPops}))
        << i;
  }
  EXPECT_GT(few[Discard::kFirstContact], many[Discard::kFirstContact]);
}

}  // namespace
}  // namespace ccdfuzz
