#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "files/case_files.hpp"
#include "files/case_json.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// A corpus of one VV contact with these expectations.
std::string corpus_of(const ScratchFolder& folder, const std::map<std::string, Expected>& expect) {
  Case value = read_cases(generated(folder, "VV", "RP", 1))->at(0).value;
  value.expect = expect;
  const std::string corpus = folder / "corpus";
  std::filesystem::create_directories(corpus);
  write_text(corpus + "/entry.json", to_json(value));
  return corpus;
}

TEST(Replay, AnyChangeExits1AlsoForTheBetter) {
  const ScratchFolder folder;
  const std::string corpus =
      corpus_of(folder, {{"tdibm-e", Outcome::kMissed}, {"tdibm-rational", Outcome::kCorrect}});
  const Finished finished = failed(ccdfuzz({"replay", corpus}));
  EXPECT_THAT(finished.out, HasSubstr("entry.json\ntdibm-e *  missed    correct  improvement"));
  EXPECT_THAT(finished.err, HasSubstr("--update writes it"));
  const auto rows = json_lines(ccdfuzz({"replay", corpus, "--json"}).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("method"), "tdibm-e");
  EXPECT_EQ(rows[0].at("expected"), "missed");
  EXPECT_EQ(rows[0].at("outcome"), "correct");
  EXPECT_EQ(rows[0].at("change"), "improvement");
  EXPECT_EQ(rows[1].at("expected"), rows[1].at("outcome"));
  EXPECT_EQ(rows[1].at("change"), "as expected");
}

TEST(Replay, ExpectsTheGivenOutcomeOfNamedMethodsOnEveryEntryThatTheyTake) {
  const ScratchFolder folder;
  const std::string corpus = corpus_of(folder, {{"tdibm-e", Outcome::kMissed}});
  const Finished correct =
      succeeded(ccdfuzz({"replay", corpus, "--methods", "tdibm-c,tdibm-e", "--expect", "correct"}));
  EXPECT_EQ(correct.out, "1 entry, 2 expectations: all as expected\n");
  const Finished red =
      failed(ccdfuzz({"replay", corpus, "--methods", "tdibm", "--expect", "correct"}));
  EXPECT_THAT(red.out, HasSubstr("tdibm   correct   missed (left root)  regression"));
  const Finished stated = failed(ccdfuzz({"replay", corpus, "--methods", "tdibm-c"}));
  EXPECT_EQ(stated.out, "1 entry, 0 expectations: 0 as expected\n");
  EXPECT_THAT(stated.err, HasSubstr("tdibm-c was asked nothing"));
  EXPECT_EQ(ccdfuzz({"replay", corpus, "--expect", "wrong"}).code, 2);
}

TEST(Replay, UpdateShowsWhatChangedAndWritesIt) {
  const ScratchFolder folder;
  const std::string corpus =
      corpus_of(folder, {{"tdibm-e", Outcome::kMissed}, {"tdibm-rational", Outcome::kCorrect}});
  const Finished updated = succeeded(ccdfuzz({"replay", corpus, "--update"}));
  EXPECT_THAT(updated.out, HasSubstr("1 as expected, 1 improvement; 1 entry written"));
  EXPECT_EQ(ccdfuzz({"replay", corpus}).out, "1 entry, 2 expectations: all as expected\n");
}

// Whose method is asked in a process of its own, before the others.
TEST(Replay, ACrashThatIsNoneAnyMoreIsAChange) {
  const ScratchFolder folder;
  const std::string corpus = corpus_of(folder, {{"tdibm-c", Outcome::kCorrect},
                                                {"tdibm-e", Outcome::kError},
                                                {"tdibm-rational", Outcome::kCorrect}});
  const Finished finished = failed(ccdfuzz({"replay", corpus, "--json", "--threads", "2"}));
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].at("method"), "tdibm-e");
  EXPECT_EQ(rows[1].at("expected"), "error");
  for (const auto& row : rows) EXPECT_EQ(row.at("outcome"), "correct") << row;
}

TEST(Replay, FailsOnACorpusWithoutExpectations) {
  const ScratchFolder folder;
  const Finished finished = failed(ccdfuzz({"replay", corpus_of(folder, {})}));
  EXPECT_THAT(finished.err, HasSubstr("nothing was judged"));
}

TEST(Replay, FailsIfOnlyPluginsThatMayNotBeAskedHaveExpectations) {
  const ScratchFolder folder;
  const Finished finished =
      failed(ccdfuzz({"replay", corpus_of(folder, {{"plugin:mine", Outcome::kMissed}})}));
  EXPECT_THAT(finished.err, HasSubstr("nothing was judged: every expectation is one of a plug-in"));
  EXPECT_THAT(finished.err, HasSubstr("--plugin"));
}

TEST(Replay, UpdateTakesNoBudgetOfTheCommandLine) {
  const ScratchFolder folder;
  const std::string corpus = corpus_of(folder, {{"tdibm-e", Outcome::kMissed}});
  for (const char* option : {"--precision", "--max-pops", "--max-seconds"}) {
    refused(ccdfuzz({"replay", corpus, "--update", option, "1"}), "--update: excludes");
  }
}

TEST(Replay, SaysByHowMuchAHitIsLate) {
  const std::string late = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-late-past-the-contact.json";
  const Finished finished =
      failed(ccdfuzz({"replay", late, "--methods", "tdibm", "--expect", "correct"}));
  EXPECT_THAT(finished.out, HasSubstr("late by 1.29e-14 (right root)"));
  const auto rows =
      json_lines(ccdfuzz({"query", late, "--methods", "tdibm,tdibm-c", "--json"}).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_GT(rows[0].at("late_by").get<double>(), 0);
  EXPECT_FALSE(rows[1].contains("late_by"));
}

TEST(Replay, AnExpectationOfAMethodThatThereIsNotIsAnErrorThatNamesTheEntry) {
  const ScratchFolder folder;
  const std::string corpus = corpus_of(folder, {{"tdibm-x", Outcome::kMissed}});
  const Finished finished = refused(ccdfuzz({"replay", corpus}), "entry.json");
  EXPECT_THAT(finished.err, HasSubstr("\"tdibm-x\""));
}

TEST(Replay, EveryClaimThatIsKnownToBeFalseHasItsCounterexample) {
  const Finished replayed = succeeded(ccdfuzz({"replay", CCDFUZZ_SOURCE_DIR "/corpus", "--json"}));
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

TEST(Replay, AClaimThatIsMendedIsAnImprovementWhichUpdateWrites) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "claims");
  const std::string path = folder / "claims/x.json";
  const auto claim = [](const char* property, const char* expect) {
    return fmt::format(R"({{"format":"ccdfuzz-claim","version":1,"property":"{}","claim":"",)"
                       R"("expect":"{}","shrunk":"to the end","text":"","choices":[1,1]}})",
                       property, expect);
  };
  write_text(path, claim("dyadic.round_trip", "fails"));
  const Finished better = failed(ccdfuzz({"replay", folder.path()}));
  EXPECT_THAT(better.out, HasSubstr("dyadic.round_trip  fails     holds  improvement"));
  EXPECT_THAT(better.out, HasSubstr("1 input of properties: 0 as expected, 1 improvement\n"));
  succeeded(ccdfuzz({"replay", folder.path(), "--update"}));
  succeeded(ccdfuzz({"replay", folder.path()}));
  write_text(path, claim("paper.overlap_as_printed", "holds"));
  EXPECT_THAT(ccdfuzz({"replay", folder.path()}).out, HasSubstr("regression"));
  write_text(path, claim("paper.overlap", "gone"));
  EXPECT_EQ(ccdfuzz({"replay", folder.path()}).code, 2);
  write_text(path, claim("paper.gone", "fails"));
  refused(ccdfuzz({"replay", folder.path()}), "x.json: property: no property \"paper.gone\"");
}

}  // namespace
}  // namespace ccdfuzz
