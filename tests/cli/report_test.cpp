#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

const std::string kEntry = CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json";
const std::string kPlugin = std::string("plugin:") + CCDFUZZ_TEST_NAIVE_PLUGIN;

/// A folder with one entry.
std::string small_corpus(const ScratchFolder& folder) {
  std::filesystem::create_directories(folder / "corpus");
  std::filesystem::copy(kEntry, folder / "corpus/entry.json");
  return folder / "corpus";
}

TEST(ReportCommand, ShowsTheFolderOfAnEvaluation) {
  const ScratchFolder folder;
  succeeded(ccdfuzz({"evaluate", kEntry, "--methods", "tdibm-e,tdibm-c", "-o", folder / "run",
                     "--report", folder / "page"}));
  const Finished again = succeeded(ccdfuzz({"report", folder / "run", "-o", folder / "again"}));
  EXPECT_EQ(page_data(folder / "page")["groups"], page_data(folder / "again")["groups"]);
}

/// A hunt's record without what is of time or of its own folders.
nlohmann::ordered_json record_without_times(const std::string& path) {
  auto record = nlohmann::ordered_json::parse(read_text(path));
  for (const char* key : {"seconds", "command", "store", "finds"}) record.erase(key);
  for (auto& cell : record["cells"]) cell.erase("cpu_seconds");
  for (auto& sample : record["course"]["samples"]) sample.erase("seconds");
  return record;
}

TEST(ReportCommand, ShowsTheFolderOfAHunt) {
  const ScratchFolder folder;
  for (const char* threads : {"1", "2"}) {
    const std::string own = folder / threads;
    succeeded(ccdfuzz({"hunt", "--cases", "2", "--methods", "tdibm,tdibm-c", "--max-pops", "10",
                       "--seed", "3", "--threads", threads, "--corpus", own + "/finds", "--report",
                       own + "/page"}));
  }
  const auto record_of_one = record_without_times(folder / "1/page/hunt.jsonl");
  EXPECT_EQ(record_of_one, record_without_times(folder / "2/page/hunt.jsonl"))
      << "a hunt by cases repeats exactly, its course included";
  const auto& course = record_of_one["course"];
  EXPECT_EQ(course["methods"].size(), 2U);
  const auto& last = course["samples"].back();
  EXPECT_GT(last["mutants"], 0);
  EXPECT_TRUE(last["margins"][1].is_number_unsigned()) << last;

  const Finished again = succeeded(ccdfuzz({"report", folder / "1/page", "-o", folder / "again"}));
  EXPECT_EQ(read_text(folder / "1/page/index.html"), read_text(folder / "again/index.html"));

  std::string record = read_text(folder / "1/page/hunt.jsonl");
  record.replace(record.find("\"n\":"), 4, "\"n\":-");
  write_text(folder / "1/page/hunt.jsonl", record);
  refused(ccdfuzz({"report", folder / "1/page", "-o", folder / "again"}),
          "hunt.jsonl: cells[0].n: -");
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
  EXPECT_EQ(page["methods"][1]["spec"], kPlugin);
  EXPECT_EQ(page["cases"][0][4], "cm");
}

TEST(ReportCommand, NeedsNeitherThePluginsNorTheFolderOfAHunt) {
  const ScratchFolder folder;
  std::filesystem::copy(CCDFUZZ_TEST_NAIVE_PLUGIN, folder / "libmine.so");
  succeeded(
      shell(fmt::format("cd {} && $ccdfuzz hunt --cases 1 --shrink none --methods "
                        "plugin:./libmine.so --corpus finds --report page",
                        folder.path())));
  std::filesystem::remove(folder / "libmine.so");
  const Finished again = succeeded(ccdfuzz({"report", folder / "page", "-o", folder / "again"}));
  const nlohmann::json page = page_data(folder / "again");
  EXPECT_EQ(page["groups"], page_data(folder / "page")["groups"]);
  EXPECT_EQ(page["methods"][0]["spec"], "plugin:./libmine.so");
  EXPECT_EQ(page["cases"][0][4], "m");

  std::filesystem::rename(folder / "finds", folder / "elsewhere");
  const Finished without = succeeded(ccdfuzz({"report", folder / "page", "-o", folder / "again"}));
  EXPECT_THAT(without.err, HasSubstr("finds: the store of the hunt is not there"));
  const nlohmann::json left = page_data(folder / "again");
  EXPECT_EQ(left["tables"].back()["id"], "finds");
  EXPECT_THAT(left["tables"].back()["rows"][0][0], HasSubstr("finds/"));
  EXPECT_TRUE(left["cases"].empty());
}

TEST(ReportCommand, ShowsTheEndOfAHuntByTime) {
  const ScratchFolder folder;
  Finished hunted;
  // Where the machine gives it no time it ends with 1, before the first query.
  for (double seconds = 0.3; seconds < 600; seconds *= 4) {
    hunted =
        ccdfuzz({"hunt", "--seconds", fmt::format("{}", seconds), "--methods", "tdibm,tdibm-c",
                 "--max-pops", "10", "--corpus", folder / "finds", "--report", folder / "page"});
    if (hunted.code != 1) break;
  }
  ASSERT_EQ(hunted.code, 0) << hunted.err;
  std::uint64_t queries = 0, mutants = 0;
  const auto record = nlohmann::ordered_json::parse(read_text(folder / "page/hunt.jsonl"));
  for (const nlohmann::ordered_json& cell : record["cells"]) {
    queries += cell["n"].get<std::uint64_t>();
    mutants += cell["mutants"].get<std::uint64_t>();
  }
  const auto& last = record["course"]["samples"].back();
  EXPECT_EQ(last["queries"], queries);
  EXPECT_EQ(last["mutants"], mutants);
  EXPECT_EQ(last["finds"], record["finds"].size());
}

TEST(ReportCommand, ShowsTheScoreboard) {
  const ScratchFolder folder;
  const std::string board = CCDFUZZ_SOURCE_DIR "/tests/report/scoreboard.json";
  const std::string corpus = small_corpus(folder);
  succeeded(ccdfuzz({"report", corpus, "--scoreboard", board, "-o", folder / "page"}));
  EXPECT_EQ(page_data(folder / "page", "scoreboard"), nlohmann::json::parse(read_text(board)));
  for (const auto& [text, complaint] : std::map<std::string, std::string>{
           {"[", "board.json"},
           {R"({"format": "else"})", "board.json: format: \"else\""},
           {R"({"format": "ccdfuzz-scoreboard", "version": 1, "drivers": [], "rows": 5})",
            "board.json: rows: 5"}}) {
    write_text(folder / "board.json", text);
    refused(
        ccdfuzz({"report", corpus, "--scoreboard", folder / "board.json", "-o", folder / "other"}),
        complaint);
    EXPECT_FALSE(std::filesystem::exists(folder / "other/index.html"));
  }
}

TEST(ReportCommand, RefusesWhatItCannotRead) {
  const ScratchFolder folder;
  for (const std::string& source : {folder / "nothing.json", kEntry}) {
    refused(ccdfuzz({"report", source, "-o", folder / "page"}), source + ": is no folder");
  }
  std::filesystem::create_directories(folder / "empty");
  EXPECT_EQ(ccdfuzz({"report", folder / "empty", "-o", folder / "page"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "page/index.html"));
  write_text(folder / "file", "");
  refused(ccdfuzz({"report", small_corpus(folder), "-o", folder / "file/page"}), "file/page");
}

}  // namespace
}  // namespace ccdfuzz
