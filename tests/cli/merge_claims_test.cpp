// merge of inputs of claims: what check, triage and a RapidCheck run keep becomes a corpus.
#include <gmock/gmock.h>

#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A claim that is known to be false, its least input, and others that fail as well.
constexpr auto kProperty = "paper.overlap_as_printed", kLeast = "1,1", kMore = "2,2", kMost = "3,3";

class MergeOfClaims : public testing::Test {
 protected:
  /// Keeps an input that fails as RapidCheck would tell it, in a folder's claims.
  void keep(const std::string& corpus, const char* choices) const {
    const Finished kept = succeeded(ccdfuzz(
        {"check", kProperty, "--choices", choices, "--save", folder_ / (corpus + "/claims")}));
    ASSERT_THAT(kept.out, HasSubstr("saved: " + file(corpus)));
  }
  std::string file(const std::string& corpus, const std::string& stem = kProperty) const {
    return folder_ / fmt::format("{}/claims/{}.json", corpus, stem);
  }
  Finished merge(std::vector<std::string> inputs, const std::string& into = "corpus") const {
    std::vector<std::string> words = {"merge", "--json", "-o", folder_ / into};
    for (const std::string& input : inputs) words.push_back(folder_ / input);
    return ccdfuzz(words);
  }
  nlohmann::json merged(const std::vector<std::string>& inputs,
                        const std::string& into = "corpus") const {
    const Finished run = succeeded(merge(inputs, into));
    return json_lines(run.out).at(0);
  }
  std::string choices_in(const std::string& path) const {
    return nlohmann::json::parse(read_text(path)).at("choices").dump();
  }

  ScratchFolder folder_;
};

TEST_F(MergeOfClaims, TakesFindsOverIntoACorpusThatReplaysThem) {
  keep("finds", kLeast);
  const auto row = merged({"finds"});
  EXPECT_EQ(row.at("claims"), 1);
  EXPECT_EQ(row.at("claims_taken_over"), 1);
  EXPECT_EQ(row.at("claims_now"), 1);
  EXPECT_EQ(row.at("entries"), 0);
  EXPECT_EQ(read_text(file("corpus")), read_text(file("finds")));
  EXPECT_THAT(ccdfuzz({"replay", folder_ / "corpus"}).out,
              HasSubstr("1 input of properties: all as expected"));
  // The folder of claims itself, again.
  EXPECT_EQ(merged({"finds/claims", "finds/claims/"}).value("claims_taken_over", 0), 0);
  EXPECT_THAT(ccdfuzz({"merge", folder_ / "finds", "-o", folder_ / "more"}).out,
              HasSubstr("1 inputs of properties, 1 taken over, 1 now in"));
}

TEST_F(MergeOfClaims, KeepsTheSimplestOfAClaimInAnyOrder) {
  keep("a", kMost);
  keep("b", kLeast);
  keep("c", kMore);
  merged({"a", "b", "c"}, "forth");
  merged({"c", "b", "a"}, "back");
  EXPECT_EQ(read_text(file("forth")), read_text(file("b")));
  EXPECT_EQ(read_text(file("back")), read_text(file("b")));
  EXPECT_EQ(merged({"c", "a"}, "back").value("claims_taken_over", 0), 0);
}

TEST_F(MergeOfClaims, KeepsWhatMustHoldBesideWhatFails) {
  keep("finds", kMore);
  fs::create_directories(folder_ / "corpus/claims");
  std::string mended = read_text(file("finds"));
  mended.replace(mended.find("\"fails\""), 7, "\"holds\"");
  mended.replace(mended.find("[2, 2]"), 6, "[0]");
  write_text(file("corpus"), mended);
  for (int turn = 0; turn < 2; ++turn) EXPECT_EQ(merged({"finds"}).at("claims_now"), 2);
  EXPECT_EQ(read_text(file("corpus")), mended);
}

TEST_F(MergeOfClaims, KeepsEntriesOfNamesOfTheirOwn) {
  keep("a", kMore);
  keep("b", kMost);
  fs::rename(file("a"), file("a", "illustrates"));
  fs::rename(file("b"), file("b", "illustrates"));
  keep("c", kLeast);
  const auto row = merged({"a", "b", "c"});
  EXPECT_EQ(row.at("claims_now"), 3);
  EXPECT_EQ(choices_in(file("corpus", "illustrates")), "[2,2]");
  EXPECT_EQ(choices_in(file("corpus")), "[1,1]");
  EXPECT_EQ(merged({"a", "b", "c", "corpus"}, "corpus").value("claims_taken_over", 0), 0);
}

TEST_F(MergeOfClaims, LeavesAFindThatDidNotFailAgain) {
  keep("finds", kLeast);
  std::string unshrunk = read_text(file("finds"));
  unshrunk.replace(unshrunk.find("cut short"), 9, "not");
  write_text(file("finds"), unshrunk);
  const auto row = merged({"finds"});
  EXPECT_EQ(row.at("claims_without_input"), 1);
  EXPECT_FALSE(fs::exists(file("corpus")));
}

TEST_F(MergeOfClaims, RefusesWhatItCannotReplayLater) {
  keep("finds", kLeast);
  std::string gone = read_text(file("finds"));
  gone.replace(gone.find(kProperty), std::string(kProperty).size(), "paper.gone");
  write_text(file("finds"), gone);
  refused(merge({"finds"}), file("finds") + ": property: no property \"paper.gone\"");
  write_text(file("finds"), "{}");
  EXPECT_EQ(merge({"finds"}).code, 2);
  refused(merge({"finds"}, "corpus/claims"), "is a folder of claims: name its corpus");
}

}  // namespace
}  // namespace ccdfuzz
