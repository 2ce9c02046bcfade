#include "properties/suites.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "properties/claim_input.hpp"

namespace ccdfuzz {
namespace {

TEST(Registry, EveryPropertyIsNamedOnceAndSaysWhatItClaims) {
  std::set<std::string> names;
  for (const Property& p : properties()) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name << " twice";
    EXPECT_NE(p.name.find('.'), std::string::npos) << p.name;
    EXPECT_FALSE(p.claim.empty()) << p.name;
    EXPECT_FALSE(p.source.empty()) << p.name;
    EXPECT_EQ(property_named(p.name)->claim, p.claim);
  }
  EXPECT_FALSE(names.empty());
}

TEST(Registry, TheSameChoicesGiveTheSameResult) {
  for (const Property& p : properties()) {
    Draw first = Draw::mostly_small(Random(7)), second = first;
    const Check a = run(p, first), b = run(p, second);
    EXPECT_EQ(a.status, b.status) << p.name;
    EXPECT_EQ(a.text, b.text) << p.name;
    EXPECT_EQ(first.numbers(), second.numbers()) << p.name;
  }
}

TEST(Suites, EachHasAClaimThatItsFuzzTargetCanRefute) {
  for (const Suite& suite : suites()) {
    EXPECT_FALSE(suite.thought_to_hold().empty()) << suite.name;
    EXPECT_TRUE(!suite.is_of_bytes || suite.claims.size() == 1) << suite.name;
  }
}

TEST(ClaimInput, NamesItsClaimAndComesBackFromItsBytes) {
  for (const Suite& suite : suites()) {
    if (suite.is_of_bytes) continue;
    for (const Property& claim : suite.thought_to_hold()) {
      const auto input = claim_input(suite, to_bytes({claim, {7, 1000}}));
      ASSERT_TRUE(input) << claim.name;
      EXPECT_EQ(input->property.name, claim.name) << "two names have one hash";
      EXPECT_EQ(input->choices, (ChoiceNumbers{7, 1000}));
    }
  }
}

TEST(ClaimInput, IsNoneForAClaimOfAnotherSuite) {
  const Suite suite = suite_named("tdibm_e").value();
  const Suite other = suite_named("linear").value();
  EXPECT_FALSE(claim_input(suite, {}));
  EXPECT_FALSE(claim_input(suite, to_bytes({other.claims[0], {}})));
  const auto known_false = *property_named("tdibm.trace");
  EXPECT_FALSE(claim_input(suite, to_bytes({known_false, {}})));
}

TEST(ClaimInput, IsTheBytesOfAText) {
  const std::vector<std::uint8_t> text = {200, 7};
  EXPECT_EQ(claim_input(suite_named("query_csv").value(), text)->choices, (ChoiceNumbers{200, 7}));
}

}  // namespace
}  // namespace ccdfuzz
