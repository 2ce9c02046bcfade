#include "generators/similar.hpp"
#include "certify/checker/check_case.hpp"

#include <gtest/gtest.h>

#include "certify/checker/check_truth.hpp"
#include "properties/rising_triangle.hpp"

namespace ccdfuzz {
namespace {

TEST(Similar, TakesItsCertificatesAlong) {
  Case base = rising_triangle();
  base.truth.clearance = rising_plane();
  for (const Similarity& change :
       {Similarity{.shift = {0x1p20, -3, 5}}, Similarity{.drift = {0x1p30, 3, -7}},
        Similarity{.space = -900}, Similarity{.time = 60}, Similarity{.time = -60},
        Similarity{{1, 2, 3}, {4, 5, 6}, -500, -60}, Similarity{{1, 2, 3}, {4, 5, 6}, 300, 60}}) {
    const auto changed = similar(base, change);
    ASSERT_TRUE(changed);
    const auto holds = check_truth(*changed);
    EXPECT_TRUE(holds) << holds.error().message();
    const auto absent = check_absence(*changed);
    EXPECT_TRUE(absent) << absent.error().message();
    EXPECT_EQ(changed->truth.contact_by(),
              Rational(*base.truth.contact_by() * power_of_two(change.time)));
  }
}

TEST(Similar, DropsATreeAndLeavesTheClaimToASearch) {
  Case base = rising_triangle();
  base.query.t_max = 0.25;
  base.truth = {};
  base.truth.collides = false;
  base.truth.proof = "T";
  base.truth.clearance = MissTree{Rational(1, 4), {}};
  const auto changed = similar(base, {.space = 3});
  ASSERT_TRUE(changed);
  EXPECT_FALSE(changed->truth.clearance);
  EXPECT_EQ(changed->truth.proof, "rational-tdibm");
}

TEST(Similar, RefusesWhatIsNoDouble) {
  const Case base = rising_triangle();
  EXPECT_FALSE(similar(base, {.shift = {0x1p60, 0, 0}})) << "bits below the last of a double";
  EXPECT_FALSE(similar(base, {.drift = {0, 0, 0x1p60}}));
  EXPECT_FALSE(similar(base, {.shift = {1e308, 0, 0}, .space = 1})) << "overflow";
  EXPECT_FALSE(similar(base, {.space = -1076})) << "below the least double";
  EXPECT_FALSE(similar(base, {.time = -2000}));
}

}  // namespace
}  // namespace ccdfuzz
