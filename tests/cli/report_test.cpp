#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

const std::string kEntry = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json";
const std::string kPlugin = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;

TEST(ReportCommand, ShowsTheFolderOfAnEvaluation) {
  const ScratchFolder folder;
  succeeded(ccdfuzz({"evaluate", kEntry, "--methods", "tdibm-e,tdibm-c", "-o", folder / "run",
                     "--report", folder / "page"}));
  const Finished again = succeeded(ccdfuzz({"report", folder / "run", "-o", folder / "again"}));
  EXPECT_EQ(page_data(folder / "page")["groups"], page_data(folder / "again")["groups"]);
}

TEST(ReportCommand, ShowsAPluginsAnswers) {
  const ScratchFolder folder;
  succeeded(ccdfuzz({"evaluate", kEntry, "--methods", "tdibm-c," + kPlugin, "-o", folder / "run",
                     "--report", folder / "page"}));
  EXPECT_THAT(read_text(folder / "page/index.html"), HasSubstr("\"" + kPlugin + "\""));
  // A kept evaluation shows what the plug-in says of itself only where that is allowed.
  const nlohmann::json own = page_data(folder / "page")["methods"];
  for (const bool allow : {true, false}) {
    std::vector<std::string> report = {"report", folder / "run", "-o", folder / "again"};
    if (allow) report.insert(report.end(), {"--allow-plugins", kPlugin});
    const Finished again = succeeded(ccdfuzz(report));
    EXPECT_EQ(page_data(folder / "again")["methods"] == own, allow);
  }
  std::filesystem::create_directories(folder / "corpus");
  nlohmann::ordered_json entry = nlohmann::ordered_json::parse(read_text(kEntry));
  entry["expect"] = {{"tdibm-c", "correct"}, {kPlugin, "missed"}};
  write_text(folder / "corpus/entry.json", entry.dump());
  succeeded(ccdfuzz({"report", folder / "corpus", "-o", folder / "page"}));
  const nlohmann::json page = page_data(folder / "page");
  EXPECT_EQ(page["methods"][0]["spec"], kPlugin);
  EXPECT_EQ(page["cases"][0][4], "mc");
}

TEST(ReportCommand, OfQueryCsvsHasTable3AndNoRateOfTheirs) {
  const ScratchFolder folder;
  succeeded(ccdfuzz({"evaluate", CCDFUZZ_SOURCE_DIR "/tests/golden/handmade/scene", "--methods",
                     "tdibm-c,tdibm", "--report", folder / "page"}));
  const nlohmann::json shown = page_data(folder / "page");
  EXPECT_EQ(shown["groups"][0]["kinds"], "linear");
  EXPECT_EQ(shown["tables"][0]["id"], "table-3");
  for (const nlohmann::json& row : shown["paper"]) {
    EXPECT_NE(row["class"], "VF") << "the paper's rate is of curved cases";
  }
}

TEST(HuntCommand, MakesAPageOfAllThatItHas) {
  const ScratchFolder folder;
  const Finished hunted = succeeded(ccdfuzz(
      {"hunt", "--cases", "2", "--methods", "tdibm," + kPlugin, "--max-pops", "10", "--shrink",
       "none", "--corpus", folder / "finds", "--report", folder / "page", "--json"}));
  std::uint64_t queries = 0, mutants = 0, finds = 0;
  for (const auto& row : json_lines(hunted.out)) {
    finds += row["row"] == "find" ? 1 : 0;
    if (row["row"] != "cell") continue;
    queries += row["n"].get<std::uint64_t>();
    mutants += row["mutants"].get<std::uint64_t>();
  }
  const nlohmann::json page = page_data(folder / "page");
  const auto& last = page["course"]["samples"].back();
  EXPECT_EQ(last[1], queries);
  EXPECT_EQ(last[2], mutants);
  EXPECT_EQ(last[3], finds);
  EXPECT_TRUE(last[4][0].is_number_unsigned()) << "the nearest margin of tdibm";
  EXPECT_EQ(page["cases"].size(), finds);
  EXPECT_EQ(page["methods"][1]["spec"], kPlugin);
  EXPECT_TRUE(page["methods"][1].contains("claims"));
}

TEST(ReportCommand, ShowsTheScoreboard) {
  const ScratchFolder folder;
  const std::string board = CCDFUZZ_SOURCE_DIR "/tests/report/scoreboard.json";
  std::filesystem::create_directories(folder / "corpus");
  std::filesystem::copy(kEntry, folder / "corpus/entry.json");
  succeeded(ccdfuzz({"report", folder / "corpus", "--scoreboard", board, "-o", folder / "page"}));
  EXPECT_EQ(page_data(folder / "page", "scoreboard"), nlohmann::json::parse(read_text(board)));
}

}  // namespace
}  // namespace ccdfuzz
