#include <gtest/gtest.h>

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

TEST(Check, WhatIsAskedForByNameIsShrunkAndSeenAgainFromItsBytes) {
  const auto rows = check({"tdibm.separation", "--count", "200"});
  ASSERT_EQ(rows.size(), 1U);
  const Finished again = shell(rows[0].at("reproduce_shrunk").get<std::string>() + " --json");
  EXPECT_EQ(again.code, 0) << "known to be false" << again.err;
  const auto repeated = json_lines(again.out);
  ASSERT_EQ(repeated.size(), 1U);
  EXPECT_EQ(repeated[0].at("status"), "fails");
  EXPECT_EQ(repeated[0].at("text"), rows[0].at("shrunk"));
  const std::string test = rows[0].at("test");
  EXPECT_NE(test.find("TEST(Found, TdibmSeparation)"), std::string::npos) << test;
  EXPECT_EQ(ccdfuzz({"check", "--hex", "00"}).code, 2);
  EXPECT_EQ(ccdfuzz({"check", "tdibm.separation", "--hex", "0"}).code, 2);
}

TEST(Check, EffortMultipliesTheInputs) {
  const std::string command = "\"$ccdfuzz\" check dyadic.round_trip --count 3 --json";
  const auto rows = json_lines(shell("CCDFUZZ_EFFORT=4 " + command).out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].at("checked"), 12);
  EXPECT_EQ(shell("CCDFUZZ_EFFORT=none " + command).code, 2);
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

TEST(Check, ByTimeChecksEveryPropertyThatIsListed) {
  const Finished listed = ccdfuzz({"properties", "--json"});
  EXPECT_EQ(listed.code, 0) << listed.err;
  const auto rows = check({"--seconds", "0.5"});
  ASSERT_EQ(rows.size(), json_lines(listed.out).size());
  for (const auto& row : rows) EXPECT_GT(row.at("checked"), 0) << row;
}

}  // namespace
}  // namespace ccdfuzz
