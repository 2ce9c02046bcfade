#include <gtest/gtest.h>

#include <filesystem>
#include <set>

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

TEST(Check, ChecksSomethingInHoweverLittleTime) {
  for (const char* name : {"dyadic.round_trip", "paper.path_is_case_1"}) {
    const auto rows = check({name, "--seconds", "1e-9", "--first", "7"});
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_GT(rows[0].at("checked"), rows[0].at("discarded")) << rows[0];
    EXPECT_EQ(rows[0].at("first"), 7);
  }
}

TEST(Check, ChecksEveryListedPropertyWhenLimitedByTime) {
  const Finished listed = succeeded(ccdfuzz({"properties", "--json"}));
  const auto rows = check({"--seconds", "0.5"});
  ASSERT_EQ(rows.size(), json_lines(listed.out).size());
  for (const auto& row : rows) EXPECT_GT(row.at("checked"), 0) << row;
}

/// What is always a hit is wrong alike. One that misses where the patches come in one order is
/// not: its counterexample names the plug-in, and is a find of it.
TEST(Check, FindsTheMethodWhoseAnswersDependOnTheOrderOfThePatches) {
  const ScratchFolder folder;
  const std::string finds = folder / "finds", seconds = ":verdict=1:seconds=30";
  const auto checked = [&](const std::string& more) {
    return ccdfuzz({"check", "metamorphic.swap", "--count", "20", "--json", "--save", finds,
                    "--plugin", "p=plugin:" CCDFUZZ_TEST_CLAIMING_PLUGIN + seconds + more,
                    "--methods", "plugin:p"});
  };
  EXPECT_EQ(json_lines(succeeded(checked("")).out).at(0).at("failed"), 0);
  const Finished found = checked(":ordered=1");
  EXPECT_EQ(found.code, 1) << found.err;
  const auto row = json_lines(found.out).at(0);
  EXPECT_LT(row.at("failed"), row.at("checked"));
  const Finished again = shell(row.at("reproduce_shrunk").get<std::string>() + " --json");
  EXPECT_EQ(again.code, 1) << again.err;
  EXPECT_EQ(json_lines(again.out).at(0).at("text"), row.at("shrunk"));
  const std::string replay = "\"$ccdfuzz\" replay " + finds;
  EXPECT_EQ(shell(replay).code, 1) << "no plug-in is started that only a file names";
  const std::string command = row.at("reproduce_shrunk"), from = " --plugin ";
  const size_t begin = command.find(from);
  succeeded(shell(replay + command.substr(begin, command.find(" --methods") - begin)));
  EXPECT_EQ(ccdfuzz({"check", "metamorphic.swap", "--methods", "none"}).code, 2);
  EXPECT_EQ(ccdfuzz({"check", "tdibm.swap", "--methods", "tdibm-c"}).code, 2);
}

TEST(Check, EveryClaimThatIsKnownToBeFalseHasItsCounterexample) {
  const ScratchFolder folder;  // a corpus of claims alone: the cases take minutes under sanitizers
  std::filesystem::copy(CCDFUZZ_SOURCE_DIR "/corpus/claims", folder / "claims");
  const Finished replayed = succeeded(ccdfuzz({"replay", folder / "", "--json"}));
  std::set<std::string> refuted;
  for (const auto& row : json_lines(replayed.out)) {
    if (row.contains("claim") && row.at("got") == "fails") refuted.insert(row.at("property"));
  }
  for (const auto& property : json_lines(ccdfuzz({"properties", "--json"}).out)) {
    if (!property.at("expected_to_fail").get<bool>()) continue;
    EXPECT_TRUE(refuted.contains(property.at("property")))
        << property << ": `ccdfuzz check` finds and shrinks one";
  }
}

}  // namespace
}  // namespace ccdfuzz
