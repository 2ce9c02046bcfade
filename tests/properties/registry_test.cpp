#include "properties/registry.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "properties/fuzz_targets.hpp"
#include "scratch_folder.hpp"

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
    Draw first = Draw::mostly_small(Random(7)), second = first;
    const Check a = p.check(first), b = p.check(second);
    EXPECT_EQ(a.status, b.status) << p.name;
    EXPECT_EQ(a.text, b.text) << p.name;
    EXPECT_EQ(first.bytes(), second.bytes()) << p.name;
  }
}

TEST(FuzzTargets, CheckClaimsThatAreThoughtToHold) {
  for (const std::string_view name : fuzz_targets()) {
    const auto target = fuzz_target_named(name);
    ASSERT_TRUE(target) << target.error().message();
    EXPECT_EQ(target->name, name);
    EXPECT_FALSE(target->claims.empty()) << name;
    for (const Property& claim : target->claims) {
      EXPECT_EQ(claim.expected, Expectation::kHolds) << name << ": " << claim.name;
    }
  }
  const auto unknown = fuzz_target_named("quarry");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().message().find(
                "no target \"quarry\"; there are: any_bits, arithmetic, case_"),
            0U)
      << unknown.error().message();
}

// The targets look themselves up when they start, and not every build has them.
TEST(FuzzTargets, AreNamedAsTheirFilesAre) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(CCDFUZZ_SOURCE_DIR "/fuzz")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    static const std::regex call("kFuzzTarget = \"([a-z_]*)\"");
    std::smatch found;
    if (!std::regex_search(text, found, call)) continue;
    EXPECT_EQ(found[1].str() + ".cpp", entry.path().filename());
    files.insert(found[1]);
  }
  const auto names = fuzz_targets();
  const std::string cmake = read_text(CCDFUZZ_SOURCE_DIR "/fuzz/CMakeLists.txt");
  const std::size_t list = cmake.find("set(ccdfuzz_targets ");
  std::istringstream built(cmake.substr(list, cmake.find(')', list) - list));
  const std::set<std::string> words{std::istream_iterator<std::string>(built), {}};
  for (const std::string_view name : names) {
    EXPECT_TRUE(words.contains(std::string(name))) << name << " is not built";
  }
  EXPECT_EQ(files, std::set<std::string>(names.begin(), names.end()));
}

TEST(FuzzTargets, TheFirstByteSaysWhichClaim) {
  const FuzzTarget several = fuzz_target_named("tdibm_e").value();
  const auto count = static_cast<std::uint8_t>(several.claims.size());
  ASSERT_GT(count, 1);
  const std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(count + 1), 7};
  const auto input = claim_input(several, bytes);
  ASSERT_TRUE(input);
  EXPECT_EQ(input->property.name, several.claims[1].name);
  EXPECT_EQ(input->choices().choose(255), 7U);
  EXPECT_FALSE(claim_input(several, {}));
  const std::vector<std::uint8_t> text = {200, 7};
  const auto whole = claim_input(fuzz_target_named("query_csv").value(), text);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->bytes.size(), 2U);
  EXPECT_FALSE(whole->seed);
}

TEST(FuzzTargets, EveryClaimCanBeNamedByAByte) {
  for (const std::string_view name : fuzz_targets()) {
    EXPECT_LE(fuzz_target_named(name).value().claims.size(), 128U) << name;
  }
}

TEST(FuzzTargets, ADrawIsTheSameAsBytes) {
  const FuzzTarget target = fuzz_target_named("tdibm_e_envelope").value();
  Draw random{Random(5)};
  std::set<std::string_view> drawn;
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
  EXPECT_EQ(drawn.size(), target.claims.size());
}

TEST(FuzzTargets, ASeedIsReadToTheLastBit) {
  const FuzzTarget target = fuzz_target_named("tdibm_e").value();
  const std::vector<std::uint8_t> input = {128, 1, 2, 3, 4, 5, 6, 7, 0x88, 9};
  EXPECT_EQ(claim_input(target, input)->seed, 0x8807060504030201U);
  EXPECT_EQ(claim_input(target, std::span(input).first(2))->seed, 1U);
}

}  // namespace
}  // namespace ccdfuzz
