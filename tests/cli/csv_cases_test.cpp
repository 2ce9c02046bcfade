// Query CSVs as cases: what other commands do with case files, they do with these.
#include <gmock/gmock.h>

#include "falling_vertex.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

/// `count` queries of three sorts, the thirds of them contacts.
std::string many_queries(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += falling_vertex(i % 3 == 0 ? "-1,2" : i % 3 == 1 ? "1,2" : "1,3", i % 3 == 0 ? 1 : 0);
  }
  return text;
}

TEST(CsvCases, APageOfThemHasTable3AndNoRateOfTheirs) {
  const ScratchFolder folder;
  succeeded(ccdfuzz({"evaluate", CCDFUZZ_SOURCE_DIR "/tests/golden/handmade/scene", "--methods",
                     "tdibm-c,tdibm", "--report", folder / "page"}));
  const nlohmann::json shown = page_data(folder / "page");
  EXPECT_EQ(shown["groups"][0]["kind"], "linear");
  EXPECT_EQ(shown["tables"][0]["id"], "table-3");
  for (const nlohmann::json& row : shown["paper"]) {
    EXPECT_NE(row["class"], "VF") << "the paper's rate is of curved cases";
  }
}

/// What the command leaves that is interrupted half a second after its start.
Finished interrupted(const std::vector<std::string>& command) {
  Process process(command);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  process.signal(SIGINT);
  return process.wait();
}

TEST(CsvCases, AnInterruptedEvaluationSaysSo) {
  const ScratchFolder folder;
  write_text(folder / "vertex-face.csv", many_queries(50'000));
  const Finished stopped =
      interrupted({"evaluate", folder / "vertex-face.csv", "--methods", "tdibm-c"});
  EXPECT_EQ(stopped.code, 128 + SIGINT);
  EXPECT_THAT(stopped.err, HasSubstr("interrupted after"));
}

TEST(CsvCases, AnInterruptedReportOfAnEvaluationShowsWhatItRead) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", run = folder / "run", page = folder / "page";
  write_text(csv, many_queries(30'000));
  succeeded(ccdfuzz({"evaluate", csv, "--methods", "tdibm-c", "-o", run}));
  const Finished stopped = interrupted({"report", run, "-o", page, "--threads", "1"});
  EXPECT_EQ(stopped.code, 128 + SIGINT);
  EXPECT_THAT(stopped.err, HasSubstr("the page shows only what was read until then"));
  EXPECT_LT(page_data(page)["groups"][0]["n"], 30'000);
}

}  // namespace
}  // namespace ccdfuzz
