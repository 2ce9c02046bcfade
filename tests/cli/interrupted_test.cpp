// Commands that a signal ends: what they leave, and how they go on.
#include <gmock/gmock.h>

#include "falling_vertex.hpp"
#include "io/run_file.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

// By Ctrl-C, Ctrl-\\, a limit of time, and whoever reads what it prints and stops.
TEST(Interrupted, ADataSetLeavesNoFileBehind) {
  for (const int signal : {SIGINT, SIGQUIT, SIGXCPU, SIGPIPE}) {
    const ScratchFolder folder;
    Process process({"generate", "--contact", "VV", "--kind", "RP", "--count", "1000000000", "-o",
                     folder / "set.jsonl"});
    process.wait_until([&] { return folder.entry_count() > 0; });
    const Finished finished = process.ended_by(signal);
    EXPECT_EQ(folder.entry_count(), 0U) << signal;
    if (signal == SIGINT) {
      EXPECT_THAT(finished.err, HasSubstr("set.jsonl was not written"));
    }
  }
}

TEST(Interrupted, ThePapersSetSaysHowToGoOn) {
  const ScratchFolder folder;
  const std::string path = folder / "stopped.jsonl.zst";
  const Finished finished =
      ended_by(SIGINT, {"generate", "--paper", "-o", path}, RunFile::path_for(path), 5000);
  EXPECT_THAT(finished.err, HasSubstr("the same command goes on"));
  EXPECT_FALSE(std::filesystem::exists(path));
}

// Interrupted, then run again with nowhere to say that it resumes.
TEST(Interrupted, ThePapersSetIsNotWrittenOnInPlaceOfAClosedStream) {
  const ScratchFolder folder;
  const std::string set = folder / "p.jsonl";
  const std::string line =
      fmt::format("timeout -s INT 1 \"$ccdfuzz\" generate --paper --one-in 400 -o {}", set);
  shell(line + " --threads 1");
  shell(line + " --threads 1 2>&-");
  EXPECT_EQ(shell("grep -c 'going on behind' " + set + ".partial").code,
            std::filesystem::exists(set + ".partial") ? 1 : 2);
}

TEST(Interrupted, APartialFileOfAnotherRunIsAnErrorThatNamesIt) {
  const ScratchFolder folder;
  const std::string path = folder / "stopped.jsonl.zst";
  const std::vector<std::string> command = {"generate", "--paper", "-o", path};
  ended_by(SIGKILL, with(command, {"--seed", "1"}), RunFile::path_for(path), 5000);
  const std::string before = read_text(path + ".partial");
  for (const std::vector<std::string>& other : std::vector<std::vector<std::string>>{
           {"--seed", "2"}, {"--seed", "1", "--shard", "0/2"}, {"--seed", "1", "--one-in", "2"}}) {
    const std::string told = refused(ccdfuzz(with(command, other)), path + ".partial").err;
    EXPECT_THAT(told, HasSubstr(other[other.size() - 2]));
  }
  EXPECT_EQ(read_text(path + ".partial"), before);
}

/// `count` queries of three sorts, the thirds of them contacts.
std::string many_queries(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += falling_vertex(i % 3 == 0 ? "-1,2" : i % 3 == 1 ? "1,2" : "1,3", i % 3 == 0 ? 1 : 0);
  }
  return text;
}

/// What the command leaves that is interrupted when it has read as much as a part of a file.
Finished interrupted(const std::vector<std::string>& command, const std::string& path) {
  Process process(command);
  process.wait_until([&] { return process.bytes_read() >= size_or_zero(path) / 16; });
  return process.ended_by(SIGINT);
}

TEST(Interrupted, AnEvaluationOfAFileSaysSo) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv";
  write_text(csv, many_queries(50'000));
  const Finished stopped = interrupted({"evaluate", csv, "--methods", "tdibm-c"}, csv);
  EXPECT_THAT(stopped.err, HasSubstr("interrupted after"));
}

TEST(Interrupted, WhatReadsCasesSaysThatItWroteNone) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", set = folder / "set.jsonl";
  write_text(csv, many_queries(50'000));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"import", "--round"}, {"prove"}}) {
    const Finished stopped = interrupted(with(command, {csv, "-o", set}), csv);
    EXPECT_THAT(stopped.err, HasSubstr("interrupted after"));
    EXPECT_THAT(stopped.err, HasSubstr("set.jsonl was not written"));
    EXPECT_EQ(folder.entry_count(), 1U);
  }
}

TEST(Interrupted, AReportOfAnEvaluationWritesNoPage) {
  const ScratchFolder folder;
  const std::string csv = folder / "vertex-face.csv", run = folder / "run", page = folder / "page";
  write_text(csv, many_queries(30'000));
  succeeded(ccdfuzz({"evaluate", csv, "--methods", "tdibm-c", "-o", run}));
  const Finished stopped =
      interrupted({"report", run, "-o", page, "--threads", "1"}, run + "/answers.jsonl");
  EXPECT_THAT(stopped.err, HasSubstr("interrupted: " + page + "/index.html was not written"));
  EXPECT_FALSE(std::filesystem::exists(page));
}

TEST(Interrupted, AnEvaluationIntoAFolderGoesOnAsTheSameCommandAlone) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "FF", "RP", 40), run = folder / "answers";
  const std::string journal = RunFile::path_for(run + "/answers.jsonl");
  const auto arguments = [&](const char* methods) {
    return std::vector<std::string>{"evaluate", set, "--methods", methods, "-o", run};
  };
  const Finished stopped = ended_by(SIGINT, arguments("tdibm-rational"), journal, 1000);
  EXPECT_THAT(stopped.err, HasSubstr("the same command goes on from there"));
  EXPECT_EQ(stopped.out, "");
  const Finished other = refused(ccdfuzz(arguments("tdibm")), journal);
  EXPECT_THAT(other.err, HasSubstr("--methods"));
  const Finished last = succeeded(ccdfuzz(arguments("tdibm-rational")));
  EXPECT_THAT(last.err, HasSubstr("going on"));
}

}  // namespace
}  // namespace ccdfuzz
