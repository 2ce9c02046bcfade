#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "process.hpp"

namespace ccdfuzz {
namespace {

std::vector<nlohmann::ordered_json> check(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "check");
  arguments.emplace_back("--json");
  return json_lines(ccdfuzz(arguments).out);
}

TEST(Check, AKnownFalseClaimFailsWithoutFailingTheCommandAndIsReproduced) {
  const auto rows = check({"tdibm.separation", "--count", "2000"});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("expected_to_fail"), true);
  EXPECT_GT(rows[0].at("failed"), 0);
  const Finished again = shell(rows[0].at("reproduce").get<std::string>() + " --json");
  EXPECT_EQ(again.code, 0) << again.err;
  const auto repeated = json_lines(again.out);
  ASSERT_EQ(repeated.size(), 1U);
  EXPECT_EQ(repeated[0].at("failed"), 1);
  EXPECT_EQ(repeated[0].at("failure"), rows[0].at("failure"));
}

TEST(Check, ShrinksANamedPropertyAndRepeatsItsFailureFromItsChoices) {
  const auto rows = check({"tdibm.separation", "--count", "200"});
  ASSERT_EQ(rows.size(), 1U);
  const Finished again = shell(rows[0].at("reproduce_shrunk").get<std::string>() + " --json");
  EXPECT_EQ(again.code, 0) << "known to be false" << again.err;
  const auto repeated = json_lines(again.out);
  ASSERT_EQ(repeated.size(), 1U);
  EXPECT_EQ(repeated[0].at("status"), "fails");
  EXPECT_EQ(repeated[0].at("expected_to_fail"), true);
  EXPECT_TRUE(shell(rows[0].at("reproduce_shrunk").get<std::string>())
                  .out.starts_with("tdibm.separation fails as expected: "));
  EXPECT_EQ(repeated[0].at("text"), rows[0].at("shrunk"));
  const std::string test = rows[0].at("test");
  EXPECT_NE(test.find("TEST(Found, TdibmSeparation)"), std::string::npos) << test;
  EXPECT_EQ(ccdfuzz({"check", "--choices", "0"}).code, 2);
  EXPECT_EQ(ccdfuzz({"check", "tdibm.separation", "--choices", "x"}).code, 2);
}

TEST(Check, EffortMultipliesTheInputs) {
  const std::string command = "\"$ccdfuzz\" check dyadic.round_trip --count 3 --json";
  const auto rows = json_lines(shell("CCDFUZZ_EFFORT=4 " + command).out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("checked"), 12);
  for (const char* bad : {"none", "0", "1000001"}) {
    const Finished refused = shell(fmt::format("CCDFUZZ_EFFORT={} {}", bad, command));
    EXPECT_EQ(refused.code, 2) << bad;
    EXPECT_EQ(refused.err,
              fmt::format("ccdfuzz: check: CCDFUZZ_EFFORT: \"{}\" is not a whole number "
                          "from 1 to 1000000\n",
                          bad));
  }
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

TEST(Check, NeedsTimeForAnInput) {
  const Finished refused =
      ccdfuzz({"check", "dyadic.round_trip", "--seconds", "1", "--first", "18446744073709551615"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--first"), std::string::npos) << refused.err;
}

TEST(Check, TheEmptyInputIsOneInputAndNotNone) {
  const Finished run = ccdfuzz({"check", "dyadic.round_trip", "--choices", ""});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "dyadic.round_trip holds\n");
}

TEST(Check, ADiscardedInputChecksNothingAndFails) {
  const Finished run = ccdfuzz({"check", "paper.one_interval", "--choices", "", "--json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(json_lines(run.out).at(0).at("status"), "is discarded");
  EXPECT_EQ(run.err, "ccdfuzz: check: nothing was checked: the input was discarded\n");
}

TEST(Check, OnlyWhatShouldHoldIsSaved) {
  const ScratchFolder folder;
  const Finished run =
      ccdfuzz({"check", "tdibm.separation", "--count", "200", "--save", folder / "saved"});
  EXPECT_NE(run.out.find("reproduce: "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("saved"), std::string::npos) << run.out;
  EXPECT_TRUE(std::filesystem::is_empty(folder / "saved"));
  EXPECT_NE(ccdfuzz({"check", "--help"}).out.find("what fails that should hold"),
            std::string::npos);
}

TEST(Check, OptionsThatWouldBeIgnoredAreRefused) {
  const std::vector<std::vector<std::string>> pairs = {
      {"--choices", "0", "--seconds", "1"}, {"--choices", "0", "--count", "5"},
      {"--choices", "0", "--seed", "2"},    {"--choices", "0", "--first", "3"},
      {"--choices", "0", "--threads", "2"}, {"--seconds", "1", "--count", "5"}};
  for (std::vector<std::string> pair : pairs) {
    const std::string first = pair[0], second = pair[2];
    pair.insert(pair.begin(), {"check", "dyadic.round_trip"});
    const Finished refused = ccdfuzz(pair);
    EXPECT_EQ(refused.code, 2) << first << " " << second;
    EXPECT_NE(refused.err.find(first), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find(second), std::string::npos) << refused.err;
  }
  const Finished empty = ccdfuzz({"check", "dyadic.round_trip", "--seconds", ""});
  EXPECT_EQ(empty.code, 2);
  EXPECT_NE(empty.err.find("--seconds: is empty"), std::string::npos) << empty.err;
}

TEST(Check, APropertyThatIsNamedTwiceIsCheckedOnce) {
  const auto rows =
      check({"dyadic.round_trip", "case_file.mutants", "dyadic.round_trip", "--count", "5"});
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("property"), "dyadic.round_trip");
  EXPECT_EQ(rows[1].at("property"), "case_file.mutants");
}

TEST(Check, TheSummaryNamesSeedAndInputs) {
  const Finished run =
      ccdfuzz({"check", "dyadic.round_trip", "--count", "5", "--seed", "42", "--first", "6"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("\n1 property, inputs from 6 of seed 42: 0 failed\n"), std::string::npos)
      << run.out;
}

TEST(Check, AClaimKnownToBeFalseThatDoesNotFailIsTold) {
  const Finished run =
      shell("CCDFUZZ_EFFORT=1 $ccdfuzz check tdibm.swap dyadic.round_trip --count 3");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("not refuted\n"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n1 expected failure did not fail: "), std::string::npos) << run.out;
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

TEST(Properties, AreListedInLinesOf80ColumnsOrAnObjectEach) {
  const std::string text = ccdfuzz({"properties"}).out;
  const auto rows = json_lines(ccdfuzz({"properties", "--json"}).out);
  EXPECT_GE(rows.size(), 50U);
  for (const auto& row : rows) {
    EXPECT_NE(text.find(row.at("property").get<std::string>() + " ("), std::string::npos) << row;
  }
  std::istringstream lines(text);
  std::string listed;
  std::getline(lines, listed);
  for (std::string line; std::getline(lines, line) && line.starts_with("    ");) {
    listed += " " + line.substr(4);
  }
  EXPECT_TRUE(listed.ends_with(" " + rows.at(0).at("claim").get<std::string>())) << listed;
  lines.clear();
  lines.str(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; }), 80) << line;
  }
}

TEST(Check, TheHelpNamesTheEnvironmentThatItReads) {
  EXPECT_NE(ccdfuzz({"check", "--help"}).out.find("CCDFUZZ_EFFORT"), std::string::npos);
}

TEST(Check, ChecksEveryListedPropertyWhenLimitedByTime) {
  const Finished listed = ccdfuzz({"properties", "--json"});
  EXPECT_EQ(listed.code, 0) << listed.err;
  const auto rows = check({"--seconds", "0.5"});
  ASSERT_EQ(rows.size(), json_lines(listed.out).size());
  for (const auto& row : rows) EXPECT_GT(row.at("checked"), 0) << row;
}

}  // namespace
}  // namespace ccdfuzz
