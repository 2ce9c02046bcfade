// Query CSVs as cases: what other commands do with case files, they do with these.
#include <gmock/gmock.h>

#include "falling_vertex.hpp"
#include "files/case_files.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Two contacts and a miss, one label wrong, one end point no double.
void write_scene(const ScratchFolder& folder) {
  fs::create_directories(folder / "scene/vertex-face");
  write_text(folder / "scene/vertex-face/0.csv",
             falling_vertex("-1,2", 1) + falling_vertex("1,2", 1));
  write_text(folder / "scene/1vf.csv", falling_vertex("-1,3", 1));
  write_text(folder / "scene/notes.txt", "no queries");
}

/// `count` queries of three sorts, the thirds of them contacts.
std::string many_queries(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += falling_vertex(i % 3 == 0 ? "-1,2" : i % 3 == 1 ? "1,2" : "1,3", i % 3 == 0 ? 1 : 0);
  }
  return text;
}

TEST(CsvCases, AFolderIsEvaluatedByTheTruthOfWhatIsAsked) {
  const ScratchFolder folder;
  write_scene(folder);
  const Finished done =
      succeeded(ccdfuzz({"evaluate", folder / "scene", "--methods", "tdibm-c", "--json"}));
  EXPECT_THAT(done.err, HasSubstr("1 of 3 labels are not the truth"));
  EXPECT_THAT(done.err, HasSubstr("1 numbers of 1 queries are no doubles and were rounded"));
  EXPECT_EQ(json_lines(done.out).at(0)["correct"], 3);
}

TEST(CsvCases, AFolderIsTheFilesInIt) {
  const ScratchFolder folder;
  write_scene(folder);
  const auto rows = [&](std::vector<std::string> files) {
    files.insert(files.begin(), "evaluate");
    files.insert(files.end(), {"--methods", "tdibm-e,tdibm", "--json"});
    const Finished done = succeeded(ccdfuzz(files));
    return untimed(done.out);
  };
  const std::string scene = folder / "scene";
  EXPECT_EQ(rows({scene + "/vertex-face/0.csv", scene + "/1vf.csv"}), rows({scene}));
}

TEST(CsvCases, ImportedOnesGiveTheSameRows) {
  const ScratchFolder folder;
  write_scene(folder);
  const std::string cases = folder / "cases.jsonl";
  succeeded(ccdfuzz({"import", folder / "scene", "-o", cases, "--round"}));
  const auto rows = [](const std::string& file) {
    return untimed(ccdfuzz({"evaluate", file, "--methods", "tdibm-e,tdibm", "--json"}).out);
  };
  EXPECT_EQ(rows(cases), rows(folder / "scene"));
}

TEST(CsvCases, OtherCommandsReadThemAsTheyReadCases) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", proven = folder / "proven.jsonl";
  write_text(csv, falling_vertex("-1,2", 1) + falling_vertex("1,2", 0));
  const auto answers = json_lines(ccdfuzz({"query", csv, "--methods", "tdibm-c", "--json"}).out);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0]["case"], csv + ":1");
  EXPECT_EQ(answers[0]["outcome"], "correct");
  EXPECT_EQ(answers[1]["case"], csv + ":9");
  EXPECT_EQ(answers[1]["verdict"], "miss");
  EXPECT_EQ(answers[1]["outcome"], "correct");
  succeeded(ccdfuzz({"replay", csv, "--methods", "tdibm-c", "--expect", "correct"}));
  succeeded(ccdfuzz({"prove", csv, "-o", proven}));
  EXPECT_EQ(ccdfuzz({"verify", proven}).out, "2 cases: 2 hold, 0 refuted, 0 unproven\n");
  EXPECT_THAT(ccdfuzz({"verify", csv}).out, HasSubstr("2 without a truth"));
}

TEST(CsvCases, APageOfThemHasTable3AndNoRateOfTheirs) {
  const ScratchFolder folder;
  write_scene(folder);
  succeeded(ccdfuzz(
      {"evaluate", folder / "scene", "--methods", "tdibm-c,tdibm", "--report", folder / "page"}));
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
