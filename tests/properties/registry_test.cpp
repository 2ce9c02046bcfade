#include "properties/registry.hpp"

#include <gtest/gtest.h>

#include <set>

namespace ccdfuzz {
namespace {

TEST(Registry, EveryPropertyIsNamedOnceAndSaysWhatItClaims) {
  std::set<std::string_view> names;
  for (const Property& p : properties()) {
    EXPECT_TRUE(names.insert(p.name).second) << p.name << " twice";
    EXPECT_NE(p.name.find('.'), std::string_view::npos) << p.name;
    EXPECT_FALSE(p.claim.empty()) << p.name;
    EXPECT_FALSE(p.source.empty()) << p.name;
    ASSERT_NE(p.check, nullptr) << p.name;
    ASSERT_TRUE(property_named(p.name));
    EXPECT_EQ(property_named(p.name)->check, p.check);
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
    RandomChoices first{Random(7)}, second{Random(7)};
    const Check a = p.check(first), b = p.check(second);
    EXPECT_EQ(a.status, b.status) << p.name;
    EXPECT_EQ(a.text, b.text) << p.name;
    EXPECT_EQ(first.bytes(), second.bytes()) << p.name;
  }
}

}  // namespace
}  // namespace ccdfuzz
