#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/run_file.hpp"
#include "killed_run.hpp"

namespace ccdfuzz {
namespace {

TEST(Evaluate, CountsEveryAnswerOncePerClassAndMethod) {
  const ScratchFolder folder;
  const std::string vv = generated(folder, "VV", "RP", 8), ve = generated(folder, "VE", "RN", 5);
  const Finished finished = ccdfuzz({"evaluate", ve, vv, "--methods", "tdibm,tdibm-e", "--json"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 4U);
  const auto is = [&](size_t i, const char* contact, const char* method, int n) {
    EXPECT_EQ(rows[i].at("class"), contact);
    EXPECT_EQ(rows[i].at("method"), method);
    EXPECT_EQ(rows[i].at("n"), n);
    int sum = 0;
    for (const char* outcome : {"correct", "missed", "late", "false_positive", "undecided",
                                "unknown", "error", "not_asked"}) {
      sum += rows[i].at(outcome).get<int>();
    }
    EXPECT_EQ(sum, n);
  };
  is(0, "VE", "tdibm", 5);
  is(1, "VE", "tdibm-e", 5);
  is(2, "VV", "tdibm", 8);
  is(3, "VV", "tdibm-e", 8);
  EXPECT_EQ(rows[0].at("negatives"), 5);
  EXPECT_EQ(rows[2].at("positives"), 8);
  EXPECT_EQ(rows[3].at("missed"), 0);
}

TEST(Evaluate, HorizonsAskPositiveCasesPastTheContactAndNegativeOnesAsTheyStand) {
  const ScratchFolder folder;
  const std::string vv = generated(folder, "VV", "RP", 3), rn = generated(folder, "VV", "RN", 2);
  const Finished finished = ccdfuzz(
      {"evaluate", vv, rn, "--methods", "tdibm-e", "--t-max-factors", "1,1+2^-30,1.5,2", "--json"});
  const auto rows = json_lines(finished.out);
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_TRUE(rows[0].at("t_max_factor").is_null());
  EXPECT_EQ(rows[0].at("negatives"), 2);
  const std::vector<double> factors = {1, 1 + 0x1p-30, 1.5, 2};
  for (size_t i = 0; i < factors.size(); ++i) {
    EXPECT_EQ(rows[i + 1].at("t_max_factor"), factors[i]);
    EXPECT_EQ(rows[i + 1].at("positives"), 3);
    EXPECT_EQ(rows[i + 1].at("late"), 0);
  }
}

TEST(Evaluate, TheReportFolderHoldsEveryAnswerInOrder) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 6), report = folder / "deep/report";
  const Finished finished =
      ccdfuzz({"evaluate", set, "--methods", "tdibm,tdibm-e", "-o", report, "--threads", "2"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  const auto answers = json_lines(read_text(report + "/answers.jsonl"));
  ASSERT_EQ(answers.size(), 1U + 6);
  EXPECT_EQ(answers[0].at("run"), "evaluate");
  EXPECT_EQ(answers[0].at("asked").at("--methods"), "tdibm,tdibm-e");
  for (size_t i = 1; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i].at("index"), i - 1);
    EXPECT_EQ(answers[i].at("case"), fmt::format("{}:{}", set, i));
    EXPECT_EQ(answers[i].at("answers").at(0).at("method"), "tdibm");
    EXPECT_EQ(answers[i].at("answers").at(1).at("method"), "tdibm-e");
  }
  EXPECT_NE(read_text(report + "/tables.md").find("| VV | tdibm |"), std::string::npos);
  const auto rows = json_lines(read_text(report + "/rows.jsonl"));
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[2]["method"], "tdibm-e");
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(report)) {
    names.insert(entry.path().filename());
  }
  EXPECT_EQ(names, (std::set<std::string>{"answers.jsonl", "rows.jsonl", "tables.md"}));
}

TEST(Evaluate, TheTableStandsBesideThePapersRates) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VE", "RN", 2);
  const Finished finished = ccdfuzz({"evaluate", set, "--methods", "tdibm", "--by-class"});
  EXPECT_NE(finished.out.find("223/1000 = 22.3 %"), std::string::npos) << finished.out;
  EXPECT_NE(finished.out.find("452/1000 = 45.2 %"), std::string::npos) << finished.out;
}

/// A small set of all kinds, with what it cost.
std::string paper_part(const ScratchFolder& folder) {
  const std::string path = folder / "paper.jsonl.zst";
  const Finished made =
      ccdfuzz({"generate", "--paper", "--one-in", "6003", "--seed", "2", "-o", path});
  EXPECT_EQ(made.code, 0) << made.err;
  return path;
}

/// The files of a report folder, without times.
std::vector<std::string> without_times(const std::string& report) {
  std::vector<std::string> all;
  for (nlohmann::ordered_json one : json_lines(read_text(report + "/answers.jsonl"))) {
    if (one.contains("answers")) {
      for (auto& answer : one["answers"]) answer.erase("seconds");
    }
    all.push_back(one.dump());
  }
  for (nlohmann::ordered_json row : json_lines(read_text(report + "/rows.jsonl"))) {
    for (const char* time : {"mean_seconds", "median_seconds", "p99_seconds"}) row.erase(time);
    all.push_back(row.dump());
  }
  return all;
}

TEST(Evaluate, WritesTheTablesAndTheirRows) {
  const ScratchFolder folder;
  const std::string set = paper_part(folder), report = folder / "report";
  const Finished finished =
      ccdfuzz({"evaluate", set, "--methods", "tdibm-e,tdibm-c", "-o", report, "--by-class"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  for (const char* word : {"Table 1", "Table 2", "Table 4", "NHP+NMN", "RP+RN", "memory", "p99",
                           "59.0 s", "175/6603", "static check"}) {
    EXPECT_NE(finished.out.find(word), std::string::npos) << word << "\n" << finished.out;
  }
  const std::string markdown = read_text(report + "/tables.md");
  for (const char* title : {"## Performance", "## Table 1", "## Table 2", "## Table 4"}) {
    EXPECT_NE(markdown.find(title), std::string::npos) << title;
  }
  const auto lines = [&](const char* name) {
    const std::string text = read_text(report + "/" + name);
    return std::count(text.begin(), text.end(), '\n');
  };
  EXPECT_EQ(lines("answers.jsonl"), 1 + 24);
  const auto rows = json_lines(read_text(report + "/rows.jsonl"));
  ASSERT_EQ(rows.size(), 18U + 24);
  for (size_t i = 0; i < 18; ++i) EXPECT_TRUE(rows[i].contains("cpu_seconds")) << rows[i];
  for (size_t i = 18; i < rows.size(); ++i) EXPECT_GT(rows[i].at("max_bytes"), 0) << rows[i];
}

TEST(Evaluate, SharesMergeIntoTheWhole) {
  const ScratchFolder folder;
  const std::string set = paper_part(folder), whole = folder / "whole";
  const std::vector<std::string> base = {"evaluate",        set,   "--methods", "tdibm-e,tdibm-c",
                                         "--t-max-factors", "1,2", "-o"};
  const auto evaluate = [&](const std::string& report, std::vector<std::string> more) {
    std::vector<std::string> arguments = base;
    arguments.push_back(report);
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished finished = ccdfuzz(arguments);
    EXPECT_EQ(finished.code, 0) << finished.err;
  };
  evaluate(whole, {"--threads", "2"});
  std::vector<std::string> merge = {"merge", "-o", folder / "merged"};
  for (const char* shard : {"2/3", "0/3", "1/3"}) {
    merge.push_back(folder / fmt::format("share-{}", shard[0]));
    evaluate(merge.back(), {"--shard", shard});
  }
  const Finished merged = ccdfuzz(merge);
  ASSERT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(without_times(folder / "merged"), without_times(whole));
  // A share left out, twice there, or of another run.
  const std::string last = merge.back();
  merge.pop_back();
  const Finished missing = ccdfuzz(merge);
  EXPECT_EQ(missing.code, 2);
  EXPECT_NE(missing.err.find("share 1/3 is missing"), std::string::npos) << missing.err;
  merge.push_back(merge.back());
  EXPECT_EQ(ccdfuzz(merge).code, 2);
  evaluate(folder / "other", {"--shard", "1/3", "--max-pops", "7"});
  merge.back() = folder / "other";
  const Finished other = ccdfuzz(merge);
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find("--max-pops 7"), std::string::npos) << other.err;
}

TEST(Merge, SaysThatTable4IsWithoutTheCostsOfASetThatIsNotThere) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 2);
  std::vector<std::string> merge = {"merge", "-o", folder / "merged"};
  for (const char* shard : {"0/2", "1/2"}) {
    merge.push_back(folder / fmt::format("share-{}", shard[0]));
    const Finished share =
        ccdfuzz({"evaluate", set, "--methods", "tdibm-c", "--shard", shard, "-o", merge.back()});
    ASSERT_EQ(share.code, 0) << share.err;
  }
  EXPECT_EQ(ccdfuzz(merge).err, "");
  std::filesystem::remove(set);
  EXPECT_EQ(ccdfuzz(merge).err, "") << "the costs are there still";
  EXPECT_EQ(std::filesystem::remove(folder / "VVRP.generation.jsonl"), true);
  const Finished merged = ccdfuzz(merge);
  EXPECT_EQ(merged.code, 0);
  EXPECT_EQ(merged.err, "ccdfuzz: merge: " + set + " is not there: Table 4 is without its costs\n");
}

TEST(Merge, WritesNoDataSetToTheStreamOfItsTable) {
  const ScratchFolder folder;
  const Finished made = ccdfuzz({"merge", folder / "share.jsonl", "-o", "-"});
  EXPECT_EQ(made.code, 2);
  EXPECT_EQ(made.out, "");
  EXPECT_NE(made.err.find("--output: - is neither"), std::string::npos) << made.err;
}

TEST(Evaluate, AnswersThatAreNotOfARunAreRefusedWithWhatIsWrong) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 2), run = folder / "run";
  const std::string answers = run + "/answers.jsonl";
  ASSERT_EQ(ccdfuzz({"evaluate", set, "--methods", "tdibm", "-o", run}).code, 0);
  const std::string whole = read_text(answers);
  const auto refused = [&](const std::string& text, const std::string& by,
                           const std::string& complaint) {
    std::string changed = whole;
    const size_t at = changed.find(text);
    ASSERT_NE(at, std::string::npos) << text << whole;
    write_text(answers, changed.replace(at, text.size(), by));
    for (const Finished& done : {ccdfuzz({"merge", run, "-o", folder / "merged"}),
                                 ccdfuzz({"report", run, "-o", folder / "page"})}) {
      EXPECT_EQ(done.code, 2);
      EXPECT_NE(done.err.find(complaint), std::string::npos) << text << done.err;
    }
  };
  refused("\"version\":1", "\"version\":3", "answers.jsonl: version");
  refused("{\"index\":0,\"of\":1}", "{\"index\":1,\"of\":1}", "there is no such share");
  refused("{\"index\":0,\"case\"", "{\"inde\":0,\"case\"", "answers.jsonl:2");
}

TEST(Evaluate, AnInterruptedOneSaysSo) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "FF", "RP", 40);
  const std::string folder_of_answers = folder / "answers";
  Process process(
      {"evaluate", set, "--methods", "tdibm-rational", "-o", folder_of_answers, "--threads", "1"});
  const std::string partial = RunFile::path_for(folder_of_answers + "/answers.jsonl");
  while (size_or_zero(partial) < 1000 && !process.is_over()) std::this_thread::yield();
  process.signal(SIGINT);
  const Finished stopped = process.wait();
  EXPECT_EQ(stopped.code, 128 + SIGINT);
  EXPECT_NE(stopped.err.find("the same command goes on from there"), std::string::npos)
      << stopped.err;
  EXPECT_EQ(stopped.out, "");
}

TEST(Evaluate, GoesOnAfterKillsAndRefusesAnotherRunsJournal) {
  const ScratchFolder folder;
  const std::string set = paper_part(folder), whole = folder / "whole", report = folder / "report";
  const std::string journal = report + "/answers.jsonl.partial";
  const auto arguments = [&](const std::string& to, const char* methods) {
    return std::vector<std::string>{"evaluate", set, "--methods", methods, "-o", to};
  };
  EXPECT_EQ(ccdfuzz(arguments(whole, "tdibm-e,tdibm")).code, 0);
  namespace fs = std::filesystem;
  ASSERT_TRUE(
      kill_often(arguments(report, "tdibm-e,tdibm"), journal, 3, [&] { fs::remove_all(report); }));
  const Finished other = ccdfuzz(arguments(report, "tdibm"));
  EXPECT_EQ(other.code, 2);
  EXPECT_NE(other.err.find(journal), std::string::npos) << other.err;
  EXPECT_NE(other.err.find("--methods"), std::string::npos) << other.err;
  const Finished last = ccdfuzz(arguments(report, "tdibm-e,tdibm"));
  EXPECT_EQ(last.code, 0) << last.err;
  EXPECT_NE(last.err.find("going on"), std::string::npos) << last.err;
  EXPECT_EQ(without_times(report), without_times(whole));
  EXPECT_FALSE(fs::exists(journal));
}

}  // namespace
}  // namespace ccdfuzz
