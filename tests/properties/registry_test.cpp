#include "properties/registry.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

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

/// The names of claims in the text of a fuzz target; those of files have a known end.
std::vector<std::string> claims_named_in(const std::filesystem::path& path) {
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  static const std::regex name("\"([a-z][a-z0-9_-]*\\.(?!(?:cpp|hpp|h|json)\")[A-Za-z0-9_]+)\"");
  std::vector<std::string> found;
  for (std::sregex_iterator m(text.begin(), text.end(), name), end; m != end; ++m) {
    found.push_back((*m)[1]);
  }
  return found;
}

// The targets look their claims up when they start, and not every build has them.
TEST(FuzzTargets, NameOnlyClaimsThatThereAreAndThatAreThoughtToHold) {
  std::size_t named = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CCDFUZZ_SOURCE_DIR "/fuzz")) {
    if (entry.path().extension() != ".cpp") continue;
    for (const std::string& claim : claims_named_in(entry.path())) {
      ++named;
      const auto property = property_named(claim);
      ASSERT_TRUE(property) << entry.path() << ": " << claim;
      EXPECT_EQ(property->expected, Expectation::kHolds) << entry.path() << ": " << claim;
    }
  }
  EXPECT_GT(named, 35U);
}

}  // namespace
}  // namespace ccdfuzz
