#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

const std::string kEntry = CCDFUZZ_SOURCE_DIR "/corpus/regressions/tdibm-e-underflow.json";

TEST(ReportCommand, ShowsAFileOfCases) {
  const ScratchFolder folder;
  const Finished made =
      ccdfuzz({"report", kEntry, "--methods", "tdibm-e,tdibm-c", "-o", folder / "page"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("index.html: 1 cases"));
  EXPECT_THAT(read_text(folder / "page/index.html"), HasSubstr("\"tdibm-e\""));
  EXPECT_THAT(read_text(folder / "page/groups.csv"), HasSubstr(",tdibm-e,1,1,0,0,1,0,"));
  EXPECT_THAT(read_text(folder / "page/counterexamples.csv"), HasSubstr(",tdibm-e,missed,"));
}

TEST(ReportCommand, ShowsACorpus) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "corpus");
  std::filesystem::copy(kEntry, folder / "corpus/entry.json");
  const Finished made = ccdfuzz({"report", folder / "corpus", "-o", folder / "page"});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(read_text(folder / "page/counterexamples.csv"), HasSubstr("entry.json,"));
}

TEST(ReportCommand, HuntAndEvaluateWriteOne) {
  const ScratchFolder folder;
  const Finished hunted = ccdfuzz({"hunt", "--cases", "1", "--methods", "tdibm", "--max-pops", "10",
                                   "--corpus", folder / "finds", "--report", folder / "hunt"});
  EXPECT_EQ(hunted.code, 0) << hunted.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "hunt/index.html"));
  const Finished evaluated =
      ccdfuzz({"evaluate", kEntry, "--methods", "tdibm-c", "--report", folder / "evaluation"});
  EXPECT_EQ(evaluated.code, 0) << evaluated.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "evaluation/index.html"));
}

TEST(ReportCommand, ShowsTheFolderOfAnEvaluation) {
  const ScratchFolder folder;
  const Finished evaluated = ccdfuzz({"evaluate", kEntry, "--methods", "tdibm-e,tdibm-c", "-o",
                                      folder / "run", "--report", folder / "page"});
  EXPECT_EQ(evaluated.code, 0) << evaluated.err;
  const Finished again = ccdfuzz({"report", folder / "run", "-o", folder / "again"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(read_text(folder / "page/groups.csv"), read_text(folder / "again/groups.csv"));
}

TEST(ReportCommand, RefusesWhatItCannotRead) {
  const ScratchFolder folder;
  EXPECT_EQ(ccdfuzz({"report", folder / "nothing.json", "-o", folder / "page"}).code, 2);
  std::filesystem::create_directories(folder / "empty");
  EXPECT_EQ(ccdfuzz({"report", folder / "empty", "-o", folder / "page"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "page/index.html"));
  write_text(folder / "file", "");
  const Finished blocked = ccdfuzz({"report", kEntry, "-o", folder / "file/page"});
  EXPECT_EQ(blocked.code, 2);
  EXPECT_THAT(blocked.err, HasSubstr("file/page"));
}

}  // namespace
}  // namespace ccdfuzz
