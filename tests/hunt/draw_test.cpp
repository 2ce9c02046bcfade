#include "hunt/draw.hpp"

#include <gtest/gtest.h>

#include <set>

#include "certify/checker/check_truth.hpp"
#include "eval/horizons.hpp"
#include "share.hpp"

namespace ccdfuzz {
namespace {

TEST(Draw, DependsOnItsArgumentsAlone) {
  for (const ContactClass contact : kContactClasses) {
    const Draw a = draw(contact, 3, 8), b = draw(contact, 3, 8);
    EXPECT_EQ(a.asked, b.asked);
    EXPECT_NE(a.asked, draw(contact, 4, 8).asked) << "another seed";
  }
}

TEST(Draw, TruthsHoldAndPositiveCasesAreAskedAtEveryHorizon) {
  for (const ContactClass contact : kContactClasses) {
    for (std::uint64_t index = 0; index < 40; index += 3 * kOneIn) {
      const Draw drawn = draw(contact, 1, index);
      ASSERT_FALSE(drawn.asked.empty());
      for (const Case& asked : drawn.asked) {
        const Result<void> checked = check_truth(asked);
        EXPECT_TRUE(checked) << name_of(contact) << " " << index << ": "
                             << checked.error().message();
        ASSERT_TRUE(asked.truth.collides.has_value());
      }
      const bool positive = *drawn.asked[0].truth.collides;
      EXPECT_EQ(drawn.asked.size(), positive ? kHorizonFactors.size() : 1U);
      for (size_t i = 1; i < drawn.asked.size(); ++i) {
        EXPECT_LT(drawn.asked[i - 1].query.t_max, drawn.asked[i].query.t_max);
      }
    }
  }
}

TEST(Draw, GoesRoundAllConstructionsAndFamiliesWithAllTheKindsThatTheyHave) {
  std::set<std::string> seen, wanted;
  for (std::uint64_t index = 0; index < 80; ++index) {
    const Origin origin = draw(ContactClass::kVV, 1, index).asked[0].origin;
    seen.insert(origin.generator + " " + origin.kind);
  }
  for (const CaseKind kind : kCaseKinds) {
    const auto want = [&](std::string_view name) {
      wanted.insert(std::string(name) + " " + std::string(name_of(kind)));
    };
    for (const Construction construction : kConstructions) want(name_of(construction));
    for (const Family family : kFamilies) {
      if (family != Family::kRegular && is_made(family, ContactClass::kVV, kind)) {
        want(name_of(family));
      }
    }
  }
  EXPECT_EQ(seen, wanted);
  EXPECT_TRUE(seen.contains("area RP"));
  EXPECT_FALSE(seen.contains("ruled RP")) << "there is none of VV";
}

TEST(DrawCache, GivesWhatDrawGivesForOldAndNewIndices) {
  DrawCache cache(5);
  for (const std::uint64_t index : {0U, 600U, 88U, 600U, 0U}) {
    EXPECT_EQ(cache.get(ContactClass::kVE, index)->asked, draw(ContactClass::kVE, 5, index).asked)
        << index;
  }
}

TEST(Horizon, ATimePastTheContactKeepsTheTruth) {
  const Case known = draw(ContactClass::kVV, 1, 1).asked[0];
  const auto later = at_horizon(known, 1.5);
  ASSERT_TRUE(later);
  EXPECT_EQ(exact(later->query.t_max), known.truth.witness->t * Rational(3, 2));
  EXPECT_EQ(later->truth.collides, true);
  Case unknown = known;
  unknown.truth = {};
  EXPECT_FALSE(at_horizon(unknown, 1.5));
}

}  // namespace
}  // namespace ccdfuzz
