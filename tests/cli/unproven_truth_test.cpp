// No command judges by what a file says and does not prove.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// A vertex that falls on a triangle, with this truth. At speed 2 they touch at t = 1/2, at speed
/// 1/2 at t = 2. The case expects tdibm-c to be wrong, which answers right.
std::string case_saying(const std::string& truth, const std::string& speed) {
  return R"({"format":"ccdfuzz-case","version":1,"patches":[{"shape":"triangle","degree":1,)"
         R"("positions":[[0,0,0],[0,1,0],[1,0,0]],"velocities":[[0,0,0],[0,0,0],[0,0,0]]},)"
         R"({"shape":"point","positions":[[0.25,0.5,1]],"velocities":[[0,0,-)" +
         speed + R"(]]}],"t_max":1,"truth":)" + truth +
         R"(,"origin":{"contact":"VF","kind":"RN"},"expect":{"tdibm-c":"false_positive"}})" + "\n";
}

constexpr const char* kFalseAbsence =
    R"({"collides":false,"proof":"L","certificate":{"clear":{"kind":"L","until":"1","closed":true}}})";
constexpr const char* kFalsePlane =
    R"({"collides":false,"proof":"P","certificate":{"clear":{"kind":"P","until":"3/2",)"
    R"("normal":["0","0","-1"],"offset":"0"}}})";
constexpr const char* kFalseRoot =
    R"({"collides":true,"certificate":{"root":{"polynomial":["-1","2"],"from":"0","by":"1"}}})";
constexpr const char* kWordUntil = R"({"clear_until":"5/4"})";
constexpr const char* kWord = R"({"collides":false,"proof":"rational-tdibm"})";

TEST(UnprovenTruth, AFalseProofIsBadInputWhereverAnswersAreJudged) {
  for (const auto& [truth, speed] :
       {std::pair{kFalseAbsence, "2"}, std::pair{kFalsePlane, "2"}, std::pair{kFalseRoot, "0.5"}}) {
    const ScratchFolder folder;
    const std::string file = folder / "case.json";
    write_text(file, case_saying(truth, speed));
    std::filesystem::create_directories(folder / "store");
    write_text(folder / "store/case.json", case_saying(truth, speed));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"query", file, "--methods", "tdibm-c"},
          {"evaluate", file, "--methods", "tdibm-c"},
          {"evaluate", file, "--methods", "tdibm-c", "-o", folder / "run"},
          {"evaluate", file, "--methods", "tdibm-c", "--report", folder / "page"},
          {"report", folder / "store", "-o", folder / "page"},
          {"minimize", file, "--method", "tdibm-c"},
          {"triage", file, "-o", folder / "finds"},
          {"export", file, "--as", "gtest", "-o", folder / "found_test.cpp"},
          {"export", file, "-o", folder / "found.csv"},
          {"hunt", "--cases", "1", "--methods", "tdibm-c", "--corpus", folder / "store"}}) {
      const Finished done = refused(ccdfuzz(command), "case.json: truth.");
      EXPECT_THAT(done.out, testing::Not(HasSubstr("false_positive")));
    }
  }
}

// A corpus is what replay checks, so that a refuted truth is a failed check as a regression is.
TEST(UnprovenTruth, ReplayNamesARefutedEntryAndFails) {
  const ScratchFolder folder;
  write_text(folder / "a.json", case_saying(kFalseAbsence, "2"));
  const Finished alone = failed(ccdfuzz({"replay", folder.path()}));
  EXPECT_THAT(alone.out, HasSubstr("refuted: " + (folder / "a.json") + ": truth."));
  write_text(folder / "b.json", case_saying(kFalseAbsence, "0.5"));  // that one is true
  const Finished both = failed(ccdfuzz({"replay", folder.path(), "--json"}));
  const auto rows = json_lines(both.out);
  ASSERT_EQ(rows.size(), 2U) << both.out;
  EXPECT_EQ(rows[0].at("truth"), "refuted");
  EXPECT_EQ(rows[1].at("outcome"), "correct");
}

TEST(UnprovenTruth, TheWordOfAMethodJudgesNothingAndIsCounted) {
  const ScratchFolder folder;
  // One of the two words is false.
  write_text(folder / "words.jsonl", case_saying(kWord, "2") + case_saying(kWord, "0.5") +
                                         case_saying(kFalseAbsence, "0.5"));
  const Finished asked =
      succeeded(ccdfuzz({"query", folder / "words.jsonl", "--methods", "tdibm-c", "--json"}));
  EXPECT_THAT(asked.err, HasSubstr("2 of 3 cases have no contact by the word of a method alone"));
  const auto answers = json_lines(asked.out);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].at("outcome"), "unknown");
  EXPECT_EQ(answers[1].at("outcome"), "unknown");
  EXPECT_EQ(answers[2].at("outcome"), "correct");

  const Finished evaluated =
      succeeded(ccdfuzz({"evaluate", folder / "words.jsonl", "--methods", "tdibm-c", "--json"}));
  EXPECT_THAT(evaluated.err, HasSubstr("2 of 3 cases"));
  const auto groups = json_lines(evaluated.out);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].at("n"), 3);
  EXPECT_EQ(groups[0].at("negatives"), 1) << "of which rates of false positives are";
  EXPECT_EQ(groups[0].at("false_positive"), 0);
  EXPECT_EQ(groups[0].at("unknown"), 2);

  succeeded(ccdfuzz({"export", folder / "words.jsonl", "--as", "gtest", "-o", folder / "t.cpp"}));
  const std::string tests = read_text(folder / "t.cpp");
  const std::string demand = "EXPECT_TRUE(answer.verdict != CCDFUZZ_HIT || may_be_near())";
  EXPECT_NE(tests.find(demand), std::string::npos);
  EXPECT_EQ(tests.find(demand), tests.rfind(demand)) << "only of the proven one";
}

TEST(UnprovenTruth, AClearUntilWithoutCertificateIsAWordToo) {
  const ScratchFolder folder;
  write_text(folder / "words.jsonl",
             case_saying(kWordUntil, "0.5") + case_saying(kFalseAbsence, "0.5"));
  std::filesystem::create_directories(folder / "store");
  write_text(folder / "store/case.json", case_saying(kWordUntil, "0.5"));
  for (const auto& [command, count] :
       {std::pair{std::vector<std::string>{"query", folder / "words.jsonl"}, "1 of 2 cases"},
        {{"evaluate", folder / "words.jsonl"}, "1 of 2 cases"},
        {{"replay", folder / "store"}, "1 of 1 cases"}}) {
    const Finished done = ccdfuzz(command);
    EXPECT_THAT(done.err,
                HasSubstr(fmt::format("{} have no contact by the word of a method", count)))
        << testing::PrintToString(command);
  }
}

TEST(UnprovenTruth, VerifyReadsOnPastARefutedOne) {
  const ScratchFolder folder;
  write_text(folder / "cases.jsonl",
             case_saying(kFalseAbsence, "2") + case_saying(kFalseAbsence, "0.5"));
  const Finished verified = failed(ccdfuzz({"verify", folder / "cases.jsonl", "--json"}));
  const auto rows = json_lines(verified.out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("case"), folder / "cases.jsonl:1");
  EXPECT_EQ(rows[0].at("truth"), "refuted");
  EXPECT_EQ(rows[1].at("truth"), "holds");
}

}  // namespace
}  // namespace ccdfuzz
