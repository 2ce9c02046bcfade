// triage of what targets of claims stopped on.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "process.hpp"
#include "properties/claim_input.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// Of the properties of misbehaving_properties.cpp.
constexpr auto kHolds = "made_up.holds", kFailsOnAll = "made_up.fails_on_all",
               kIsDiscarded = "made_up.is_discarded", kAborts = "made_up.aborts",
               kAbortsWhenShrunk = "made_up.aborts_when_shrunk", kFailsOnce = "made_up.fails_once",
               kIsSlow = "made_up.is_slow", kWantsMemory = "made_up.wants_memory";

std::string input_of(const char* property, const ChoiceNumbers& choices) {
  const auto unchecked = [](Draw&) {};
  const std::vector<std::uint8_t> bytes = to_bytes({{property, "", "", unchecked}, choices});
  return {bytes.begin(), bytes.end()};
}
std::string input_of(const char* property, std::uint64_t number) {
  return input_of(property, ChoiceNumbers{number});
}

class TriageOfClaims : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(inputs_);
    write_text(inputs_ + "/a", "");
    write_text(inputs_ + "/b", input_of(kHolds, 1));
    write_text(inputs_ + "/c", input_of(kIsDiscarded, 1));
    write_text(inputs_ + "/d", input_of(kFailsOnAll, 1));
    write_text(inputs_ + "/e", input_of(kFailsOnAll, 0));
    write_text(inputs_ + "/f", input_of(kAborts, 99));
    write_text(inputs_ + "/g", input_of(kAbortsWhenShrunk, 10'000));
  }

  void no_inputs() const {
    std::filesystem::remove_all(inputs_);
    std::filesystem::create_directory(inputs_);
  }

  /// One that takes seconds to shrink.
  void slow_input_alone() const {
    no_inputs();
    write_text(inputs_ + "/a", input_of(kIsSlow, ChoiceNumbers(100, 456)));
  }

  Finished triage(std::vector<std::string> options) const {
    options.insert(options.begin(), {"triage", "--target", "any", inputs_});
    if (std::ranges::find(options, "-o") == options.end())
      options.insert(options.end(), {"-o", finds_});
    return Process(std::move(options), "", CCDFUZZ_TEST_MISBEHAVING_PROPERTIES).wait();
  }

  const ScratchFolder folder_;
  const std::string inputs_ = folder_ / "inputs", finds_ = folder_ / "finds";
};

TEST_F(TriageOfClaims, KeepsOneOfEachClaimAndError) {
  const Finished run = succeeded(triage({"--json"}));
  const auto rows = json_lines(run.out);
  ASSERT_EQ(rows.size(), 4U) << run.out;
  const std::vector<std::pair<std::string, std::string>> wanted = {
      {"made_up.fails_on_all", "refuted claim"},
      {"made_up.aborts", "crash SIGABRT"},
      {"made_up.aborts_when_shrunk", "refuted claim"}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(rows[i]["property"], wanted[i].first);
    EXPECT_EQ(rows[i]["outcome"], wanted[i].second);
    const auto saved = nlohmann::json::parse(read_text(rows[i]["saved"]));
    EXPECT_EQ(saved["property"], wanted[i].first);
    EXPECT_EQ(saved["expect"], "fails");
    EXPECT_NE(saved["as_found"], "");
  }
  EXPECT_EQ(rows[0]["text"], "drew 0");
  EXPECT_THAT(rows[1]["text"], testing::StartsWith("crash SIGABRT: "));
  const auto& summary = rows[3];
  EXPECT_EQ(summary["inputs"], 7);
  EXPECT_EQ(summary["failures"], 4);
  EXPECT_EQ(summary["known"], 1);
  EXPECT_EQ(summary["harmless"], 3);
  EXPECT_EQ(summary["finds"], 3);
}

TEST_F(TriageOfClaims, ShrinksAndPrintsTheCommandThatShowsIt) {
  const auto rows = json_lines(triage({"--json"}).out);
  ASSERT_EQ(rows.size(), 4U);
  // 1001, and 99: the least with which the property fails, and dies.
  const std::vector<std::string> least = {"''", "99", "1001"};
  for (std::size_t i = 0; i < least.size(); ++i) {
    const std::string command = rows[i]["reproduce"];
    EXPECT_THAT(command, testing::EndsWith(" --choices " + least[i]));
    const int code = shell(command).code;
    EXPECT_EQ(code, i == 1 ? 128 + SIGABRT : 1) << command;
  }
}

TEST_F(TriageOfClaims, FindsNothingThatIsStored) {
  EXPECT_THAT(triage({}).out, HasSubstr("; 3 new in "));
  EXPECT_THAT(triage({}).out, HasSubstr("4 of them like one that is stored; 3 inputs on which no "
                                        "full run fails; 0 new in "));
  const std::string known = finds_;
  std::filesystem::rename(finds_, folder_ / "known");
  EXPECT_THAT(triage({"--known", folder_ / "known"}).out, HasSubstr("; 0 new in "));
  EXPECT_THAT(triage({"--remove"}).out, HasSubstr("; 3 new in "));
  EXPECT_TRUE(std::filesystem::is_empty(inputs_));
}

TEST_F(TriageOfClaims, KeepsWhatCouldNotBeShrunkUntilThereIsBetter) {
  slow_input_alone();
  const auto first = json_lines(triage({"--seconds", "0.1", "--json"}).out);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0]["cut_short"], true);
  // Now it crashes when it is shrunk for longer, which is not the failure that is shrunk.
  const auto second = json_lines(triage({"--json"}).out);
  ASSERT_EQ(second.size(), 2U) << "the first was not complete";
  EXPECT_EQ(second[0]["cut_short"], false);
  EXPECT_EQ(first[0]["saved"], second[0]["saved"]);
  EXPECT_EQ(nlohmann::json::parse(read_text(second[0]["saved"]))["shrunk"], "to the end");
  EXPECT_THAT(triage({}).out, HasSubstr("; 0 new in "));
}

TEST_F(TriageOfClaims, AWorseFindTakesNobodysPlace) {
  slow_input_alone();
  const auto first = json_lines(triage({"--seconds", "0.4", "--json"}).out);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0]["cut_short"], true);
  const auto second = json_lines(triage({"--seconds", "0.02", "--json"}).out);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0]["finds"], 0);
  EXPECT_TRUE(std::filesystem::exists(first[0]["saved"].get<std::string>()));
}

TEST_F(TriageOfClaims, AFileThatIsNoFindInItsPlaceIsAnErrorAndStays) {
  std::filesystem::create_directories(finds_ + "/claims");
  const std::string path = finds_ + "/claims/made_up.fails_on_all.json";
  write_text(path, "{}");
  refused(triage({}), path + ": ");
  EXPECT_EQ(read_text(path), "{}");
}

TEST_F(TriageOfClaims, KeepsLookingWhereAFindDoesNotFailAgain) {
  no_inputs();
  write_text(inputs_ + "/a", input_of(kFailsOnce, 1));
  EXPECT_THAT(triage({}).out, HasSubstr("made_up.fails_once, not shrunk: "));
  EXPECT_THAT(triage({}).out, HasSubstr("; 1 new in "));
}

TEST_F(TriageOfClaims, WantOfMemoryIsNoRefutation) {
  no_inputs();
  write_text(inputs_ + "/a", input_of(kWantsMemory, 99));
  const auto rows = json_lines(triage({"--json"}).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["outcome"], "memory");
}

TEST_F(TriageOfClaims, RefusesFoldersBeforeItWorks) {
  write_text(folder_ / "file", "");
  for (const char* option : {"-o", "--known"}) {
    const Finished run = refused(triage({option, folder_ / "file"}), folder_ / "file");
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(triage({"--known", folder_ / "none"}).code, 2);
}

TEST_F(TriageOfClaims, RefusesWhatIsOfMethods) {
  for (const char* option : {"--methods", "--max-pops", "--max-seconds"}) {
    refused(triage({option, "1"}), option);
  }
}

TEST(TriageOfTargets, RefusesAnUnknownTargetAndReadsThatOfAny) {
  const ScratchFolder folder;
  write_text(folder / "input", "a,b");
  refused(ccdfuzz({"triage", folder / "input", "--target", "quarry"}),
          "--target: no target \"quarry\"; there are: any_bits, any_environment, ");
  const Finished read = succeeded(ccdfuzz(
      {"triage", folder / "input", "--target", "query_csv", "-o", folder / "finds", "--json"}));
  EXPECT_EQ(json_lines(read.out).back()["harmless"], 1);
}

}  // namespace
}  // namespace ccdfuzz
