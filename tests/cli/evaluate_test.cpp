#include <gtest/gtest.h>

#include <algorithm>

#include "falling_vertex.hpp"
#include "io/run_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

/// A small set of all kinds, with what it cost.
std::string paper_part(const ScratchFolder& folder) {
  const std::string path = folder / "paper.jsonl.zst";
  succeeded(ccdfuzz({"generate", "--paper", "--one-in", "6003", "--seed", "2", "-o", path}));
  return path;
}

/// The files of a report folder, without times.
std::vector<std::string> without_times(const std::string& report) {
  return untimed(read_text(report + "/answers.jsonl") + read_text(report + "/rows.jsonl"));
}

TEST(Evaluate, SharesMergeIntoTheWhole) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "vertex-face");
  write_text(folder / "vertex-face/0.csv", falling_vertex("-1,2", 1) + falling_vertex("1,2", 0));
  write_text(folder / "vertex-face/1.csv", falling_vertex("-1,3", 1));
  const std::vector<std::string> base = {"evaluate",  paper_part(folder), folder / "vertex-face",
                                         "--methods", "tdibm-e,tdibm-c",  "--t-max-factors",
                                         "1,2"};
  const auto evaluate = [&](const std::string& report, std::vector<std::string> more) {
    more.insert(more.end(), {"-o", report});
    succeeded(ccdfuzz(with(base, more)));
  };
  const std::string whole = folder / "whole";
  evaluate(whole, {"--threads", "2"});
  std::vector<std::string> merge = {"merge", "-o", folder / "merged"};
  for (const char* shard : {"2/3", "0/3", "1/3"}) {
    merge.push_back(folder / fmt::format("share-{}", shard[0]));
    evaluate(merge.back(), {"--shard", shard});
  }
  succeeded(ccdfuzz(merge));
  EXPECT_EQ(without_times(folder / "merged"), without_times(whole));
  // One of another run.
  evaluate(folder / "other", {"--shard", "1/3", "--max-pops", "7"});
  merge.back() = folder / "other";
  refused(ccdfuzz(merge), "--max-pops 7");
}

TEST(Evaluate, AnInterruptedOneSaysSoAndGoesOnAsTheSameCommandAlone) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "FF", "RP", 40), run = folder / "answers";
  const std::string journal = RunFile::path_for(run + "/answers.jsonl");
  const auto arguments = [&](const char* methods) {
    return std::vector<std::string>{"evaluate", set, "--methods", methods, "-o", run};
  };
  const Finished stopped = ended_by(SIGINT, arguments("tdibm-rational"), journal, 1000);
  EXPECT_EQ(stopped.code, 128 + SIGINT);
  EXPECT_THAT(stopped.err, testing::HasSubstr("the same command goes on from there"));
  EXPECT_EQ(stopped.out, "");
  const Finished other = refused(ccdfuzz(arguments("tdibm")), journal);
  EXPECT_THAT(other.err, testing::HasSubstr("--methods"));
  const Finished last = succeeded(ccdfuzz(arguments("tdibm-rational")));
  EXPECT_THAT(last.err, testing::HasSubstr("going on"));
}

}  // namespace
}  // namespace ccdfuzz
