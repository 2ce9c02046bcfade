#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::vector<nlohmann::ordered_json> check(const std::vector<std::string>& arguments) {
  return json_lines(ccdfuzz(with({"check", "--json"}, arguments)).out);
}

TEST(Check, ShrinksANamedPropertyAndRepeatsItsFailureFromItsChoices) {
  const auto rows = check({"tdibm.separation", "--count", "200"});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_GT(rows[0].at("failed"), 0);
  const Finished as_found = shell(rows[0].at("reproduce").get<std::string>() + " --json");
  EXPECT_EQ(as_found.code, 0) << "known to be false" << as_found.err;
  EXPECT_EQ(json_lines(as_found.out).at(0).at("failure"), rows[0].at("failure"));
  const Finished again = shell(rows[0].at("reproduce_shrunk").get<std::string>() + " --json");
  EXPECT_EQ(again.code, 0) << "known to be false" << again.err;
  const auto repeated = json_lines(again.out);
  ASSERT_EQ(repeated.size(), 1U);
  EXPECT_EQ(repeated[0].at("status"), "fails");
  EXPECT_EQ(repeated[0].at("expected_to_fail"), true);
  EXPECT_TRUE(shell(rows[0].at("reproduce_shrunk").get<std::string>())
                  .out.starts_with("tdibm.separation fails as expected: "));
  EXPECT_EQ(repeated[0].at("text"), rows[0].at("shrunk"));
}

TEST(Check, EffortMultipliesTheInputs) {
  const std::string command = "\"$ccdfuzz\" check dyadic.round_trip --count 3 --json";
  const auto rows = json_lines(shell("CCDFUZZ_EFFORT=4 " + command).out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("checked"), 12);
  const Finished bad = shell("CCDFUZZ_EFFORT=0 " + command);
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, testing::StartsWith("ccdfuzz: check: CCDFUZZ_EFFORT: \"0\" is not"));
}

TEST(Check, DependsOnSeedAndIndicesAlone) {
  const std::string name = "tdibm-c.no_false_negative";
  auto one = check({name, "--count", "300", "--threads", "1"});
  auto two = check({name, "--count", "300", "--threads", "2"});
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 1U);
  one[0].erase("seconds");
  two[0].erase("seconds");
  EXPECT_EQ(one, two);
  const auto head = check({name, "--count", "100"}),
             tail = check({name, "--count", "200", "--first", "100"});
  EXPECT_EQ(head.at(0).at("discarded").get<int>() + tail.at(0).at("discarded").get<int>(),
            one[0].at("discarded").get<int>());
}

TEST(Check, ChecksSomethingInHoweverLittleTime) {
  for (const char* name : {"dyadic.round_trip", "paper.one_interval"}) {
    const auto rows = check({name, "--seconds", "1e-9", "--first", "7"});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_GT(rows[0].at("checked"), rows[0].at("discarded")) << rows[0];
    EXPECT_EQ(rows[0].at("first"), 7);
  }
}

TEST(Check, OnlyWhatShouldHoldIsSaved) {
  const ScratchFolder folder;
  const Finished run =
      ccdfuzz({"check", "tdibm.separation", "--count", "200", "--save", folder / "saved"});
  EXPECT_THAT(run.out, testing::HasSubstr("reproduce: "));
  EXPECT_THAT(run.out, testing::Not(testing::HasSubstr("saved")));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "saved"));
}

TEST(Check, APropertyThatIsNamedTwiceIsCheckedOnce) {
  const auto rows =
      check({"dyadic.round_trip", "case_file.mutants", "dyadic.round_trip", "--count", "5"});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("property"), "dyadic.round_trip");
  EXPECT_EQ(rows[1].at("property"), "case_file.mutants");
}

TEST(Check, AClaimKnownToBeFalseThatDoesNotFailIsTold) {
  const Finished run =
      succeeded(shell("CCDFUZZ_EFFORT=1 $ccdfuzz check tdibm.swap dyadic.round_trip --count 3"));
  EXPECT_THAT(run.out, testing::HasSubstr("not refuted\n"));
  EXPECT_THAT(run.out, testing::HasSubstr("\n1 expected failure did not fail: "));
}

TEST(Check, NamesSimilarPropertiesForAnUnknownOneOrWhereTheListIs) {
  const auto said = [](const char* name) { return ccdfuzz({"check", name}).err; };
  EXPECT_EQ(
      said("swap"),
      "ccdfuzz: check: no property \"swap\"; there are: tdibm.swap, tdibm-c.contact_swapped\n");
  for (const std::string name : {".", "e", "nosuch", "paper"}) {
    EXPECT_EQ(said(name.c_str()),
              "ccdfuzz: check: no property \"" + name + "\"; the list is: ccdfuzz properties\n");
  }
}

TEST(Check, ChecksEveryListedPropertyWhenLimitedByTime) {
  const Finished listed = succeeded(ccdfuzz({"properties", "--json"}));
  const auto rows = check({"--seconds", "0.5"});
  ASSERT_EQ(rows.size(), json_lines(listed.out).size());
  for (const auto& row : rows) EXPECT_GT(row.at("checked"), 0) << row;
}

}  // namespace
}  // namespace ccdfuzz
