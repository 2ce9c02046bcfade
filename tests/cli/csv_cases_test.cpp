// Query CSVs as cases: what other commands do with case files, they do with these.
#include <gmock/gmock.h>

#include <set>

#include "falling_vertex.hpp"
#include "files/case_files.hpp"
#include "io/run_file.hpp"
#include "killed_run.hpp"

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

TEST(CsvCases, AFolderIsEvaluatedByTheTruthOfItsQueries) {
  const ScratchFolder folder;
  write_scene(folder);
  const std::vector<std::string> command = {"evaluate", folder / "scene", "--methods",
                                            "tdibm-c,tdibm-e", "--by-class"};
  const Finished done = succeeded(ccdfuzz(command));
  EXPECT_THAT(done.out, HasSubstr("Table 3, beside the paper's"));
  EXPECT_THAT(done.out, HasSubstr("107/21209"));
  EXPECT_THAT(done.err, HasSubstr("1 of 3 labels are not the truth"));
  EXPECT_THAT(done.err, HasSubstr("1 numbers of 1 queries are no doubles and were rounded"));
  std::vector<std::string> as_json = command;
  as_json.push_back("--json");
  const auto rows = json_lines(ccdfuzz(as_json).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["class"], "VF");
  EXPECT_EQ(rows[0]["kinds"], "linear");
  EXPECT_EQ(rows[0]["n"], 3);
  EXPECT_EQ(rows[0]["positives"], 2);
  EXPECT_EQ(rows[0]["correct"], 3);
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
  EXPECT_EQ(ccdfuzz({"evaluate"}).code, 2);
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

TEST(CsvCases, AreTheSameOnAnyNumberOfThreads) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", out = folder / "out.jsonl";
  write_text(csv, many_queries(300));
  std::set<std::string> imports;
  std::set<std::vector<std::string>> evaluations;
  for (const char* threads : {"1", "2", "7"}) {
    succeeded(ccdfuzz({"import", csv, "--round", "-o", out, "--threads", threads}));
    imports.insert(read_text(out));
    const std::string answers = folder / threads;
    succeeded(ccdfuzz(
        {"evaluate", csv, "--methods", "tdibm-c,tdibm", "--threads", threads, "-o", answers}));
    evaluations.insert(untimed(read_text(answers + "/answers.jsonl")));
  }
  EXPECT_EQ(imports.size(), 1U);
  EXPECT_EQ(evaluations.size(), 1U);
}

TEST(CsvCases, SharesOfAFolderMergeIntoTheWhole) {
  const ScratchFolder folder;
  write_scene(folder);
  write_text(folder / "scene/vertex-face/1.csv", many_queries(20));
  const auto evaluate = [&](const std::string& to, const std::vector<std::string>& more) {
    succeeded(ccdfuzz(
        with({"evaluate", folder / "scene", "--methods", "tdibm-c,tdibm", "-o", to}, more)));
  };
  evaluate(folder / "whole", {});
  std::vector<std::string> merge = {"merge", "-o", folder / "merged"};
  for (const char* shard : {"0/3", "1/3", "2/3"}) {
    merge.push_back(folder / fmt::format("share-{}", shard[0]));
    evaluate(merge.back(), {"--shard", shard});
  }
  succeeded(ccdfuzz(merge));
  for (const char* file : {"/answers.jsonl", "/rows.jsonl"}) {
    EXPECT_EQ(untimed(read_text(folder / "merged" + file)),
              untimed(read_text(folder / "whole" + file)));
  }
  const Finished page = succeeded(ccdfuzz({"report", folder / "merged", "-o", folder / "page"}));
  const nlohmann::json shown = page_data(folder / "page");
  EXPECT_EQ(shown["groups"][0]["kind"], "linear");
  EXPECT_EQ(shown["tables"][0]["id"], "table-3");
  for (const nlohmann::json& row : shown["paper"]) {
    EXPECT_NE(row["class"], "VF") << "the paper's rate is of curved cases";
  }
}

TEST(CsvCases, NameErrorsByFileLineAndColumn) {
  const ScratchFolder folder;
  fs::create_directories(folder / "vertex-face");
  const std::string csv = folder / "vertex-face/0.csv";
  std::string text = falling_vertex("-1,2", 1) + falling_vertex("1,2", 0);
  text.replace(text.rfind("1,1"), 3, "1,0");
  write_text(csv, text);
  for (const char* command :
       {"evaluate {0} --methods tdibm", "evaluate {0} --methods tdibm -o {1}/answers",
        "query {0} --methods tdibm", "verify {0}", "prove {0} -o {1}/p.jsonl",
        "import {0} -o {1}/i.jsonl", "replay {0} --methods tdibm --expect correct"}) {
    refused(shell("$ccdfuzz " + fmt::format(fmt::runtime(command), csv, folder.path())),
            csv + ":16: column 2 (xd): \"0\" is not > 0");
  }
}

TEST(CsvCases, AFolderOrFileOfWhichNothingIsKnownIsRefused) {
  const ScratchFolder folder;
  fs::create_directories(folder / "empty");
  write_text(folder / "queries.csv", falling_vertex("-1,2", 1));
  refused(ccdfuzz({"evaluate", folder / "empty"}), "empty: is a folder without a .csv in it");
  refused(ccdfuzz({"evaluate", folder / "queries.csv"}), "queries.csv: does not tell its layout");
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
