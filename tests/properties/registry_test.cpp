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

TEST(Registry, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  const auto unknown = property_named("dyadic");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message().find("dyadic.round_trip"), std::string::npos);
}

TEST(Registry, TheSameChoicesGiveTheSameResult) {
  for (const Property& p : properties()) {
    Draw first = Draw::mostly_small(Random(7)), second = first;
    const Check a = run(p, first), b = run(p, second);
    EXPECT_EQ(a.status, b.status) << p.name;
    EXPECT_EQ(a.text, b.text) << p.name;
    EXPECT_EQ(first.bytes(), second.bytes()) << p.name;
  }
}

TEST(Suites, EachHasAClaimThatItsFuzzTargetCanRefute) {
  for (const Suite& suite : suites()) {
    EXPECT_FALSE(suite.thought_to_hold().empty()) << suite.name;
    EXPECT_TRUE(!suite.reads_text || suite.claims.size() == 1) << suite.name;
  }
}

TEST(Suites, AnUnknownNameIsAnErrorThatListsTheKnownOnes) {
  const auto unknown = suite_named("quarry");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().message().find(
                "no target \"quarry\"; there are: any_bits, any_environment, arithmetic, case_"),
            0U)
      << unknown.error().message();
}

TEST(FuzzTargets, TheFirstByteSaysWhichClaim) {
  const Suite several = suite_named("tdibm_e").value();
  const auto count = static_cast<std::uint8_t>(several.thought_to_hold().size());
  ASSERT_GT(count, 1);
  const std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(count + 1), 7};
  const auto input = claim_input(several, bytes);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->property.name, several.thought_to_hold()[1].name);
  EXPECT_EQ(input->choices().choose(255), 7U);
  EXPECT_FALSE(claim_input(several, {}));
  const std::vector<std::uint8_t> text = {200, 7};
  const auto whole = claim_input(suite_named("query_csv").value(), text);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->bytes.size(), 2U);
  EXPECT_FALSE(whole->seed);
}

TEST(FuzzTargets, ADrawIsTheSameAsBytes) {
  const Suite target = suite_named("tdibm_e_envelope").value();
  Draw random{Random(5)};
  std::set<std::string> drawn;
  for (int i = 0; i < 200; ++i) {
    const std::vector<std::uint8_t> input = drawn_input(random);
    const auto of_draws = claim_input(target, input);
    const auto bytes = drawn_as_bytes(target, input);
    ASSERT_TRUE(of_draws && of_draws->seed && bytes);
    const auto of_bytes = claim_input(target, *bytes);
    ASSERT_TRUE(of_bytes);
    EXPECT_FALSE(of_bytes->seed);
    EXPECT_EQ(of_bytes->property.name, of_draws->property.name);
    drawn.insert(of_draws->property.name);
    auto a = of_draws->choices(), b = of_bytes->choices();
    const Check x = run(of_draws->property, a), y = run(of_bytes->property, b);
    EXPECT_EQ(x.status, y.status);
    EXPECT_EQ(x.text, y.text);
    EXPECT_EQ(a.numbers(), b.numbers());
    EXPECT_FALSE(drawn_as_bytes(target, *bytes)) << "they are bytes already";
  }
  EXPECT_EQ(drawn.size(), target.thought_to_hold().size());
}

TEST(FuzzTargets, ASeedIsReadToTheLastBit) {
  const Suite target = suite_named("tdibm_e").value();
  const std::vector<std::uint8_t> input = {128, 1, 2, 3, 4, 5, 6, 7, 0x88, 9};
  EXPECT_EQ(claim_input(target, input)->seed, 0x8807060504030201U);
  EXPECT_EQ(claim_input(target, std::span(input).first(2))->seed, 1U);
}

}  // namespace
}  // namespace ccdfuzz
