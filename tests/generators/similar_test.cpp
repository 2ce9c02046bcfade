#include "generators/similar.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_truth.hpp"
#include "generators/finalize.hpp"
#include "generators/generate.hpp"
#include "generators/planted.hpp"
#include "generators/prescribe.hpp"

namespace ccdfuzz {
namespace {

Case planted(ContactClass contact, std::uint64_t key) {
  Random random(key);
  const Scene scene = planted_scene(contact, random);
  return finalize(scene, to_query(scene).value(), CaseKind::kRP, std::nullopt);
}

TEST(Planted, TouchesInTheFeaturesOfItsClass) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t key = 0; key < 50; ++key) {
      Random random(key);
      const Scene scene = planted_scene(contact, random);
      for (size_t s = 0; s < 2; ++s) {
        EXPECT_EQ(feature_at(scene.contact.x[s]), features_of(contact)[s]);
      }
      EXPECT_TRUE(check_truth(planted(contact, key))) << name_of(contact) << ' ' << key;
    }
  }
}

TEST(Similar, KeepsTheTruthWhereTheCheckerLooks) {
  for (const ContactClass contact : kContactClasses) {
    for (const Similarity& change :
         {Similarity{.shift = {0x1p40, -0x1p44, 0x1.8p39}}, Similarity{.drift = {0x1p30, 3, 0}},
          Similarity{.space = -1000}, Similarity{.space = 900}, Similarity{.time = 60},
          Similarity{{1, 2, 3}, {4, 5, 6}, -500, -60}}) {
      const auto changed = similar(planted(contact, 5), change);
      ASSERT_TRUE(changed) << name_of(contact);
      const auto holds = check_truth(*changed);
      EXPECT_TRUE(holds) << holds.error().message();
    }
  }
  GeneratorOptions options;
  options.construction = Construction::kOneSided;
  const Case regular = generate(options, 3).value;
  const auto scaled = similar(regular, {.space = 7, .time = -3});
  ASSERT_TRUE(scaled);
  EXPECT_TRUE(check_truth(*scaled)) << "clear_until too";
  EXPECT_EQ(*scaled->truth.clear_until * 8, *regular.truth.clear_until);
}

TEST(Similar, RefusesWhatIsNoDouble) {
  const Case base = planted(ContactClass::kFF, 5);
  EXPECT_FALSE(similar(base, {.shift = {0x1p50, 0, 0}})) << "bits below the last of a double";
  EXPECT_FALSE(similar(base, {.drift = {0x1p60, 0, 0}}));
  EXPECT_FALSE(similar(base, {.shift = {1e308, 0, 0}, .space = 1})) << "overflow";
  EXPECT_FALSE(similar(base, {.space = -1074})) << "subnormal";
  EXPECT_FALSE(similar(base, {.time = -2000}));
}

}  // namespace
}  // namespace ccdfuzz
