// What happens where the streams, files and names that the program is given are odd.
#include <gmock/gmock.h>

#include "process.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

constexpr const char* kGenerate = "generate --contact VV --kind RP --count 3 --seed 1 -o ";

TEST(StandardStreams, AnUnwritableStderrChangesNoExitCode) {
  const ScratchFolder folder;
  for (const char* to : {"2>/dev/full", "2>&-"}) {
    const std::string path = folder / "y.jsonl";
    EXPECT_EQ(shell(fmt::format("\"$ccdfuzz\" {}{} {}", kGenerate, path, to)).code, 0) << to;
    EXPECT_EQ(shell(fmt::format("\"$ccdfuzz\" query nowhere.jsonl {}", to)).code, 2) << to;
    EXPECT_EQ(shell(fmt::format("\"$ccdfuzz\" nonsense {}", to)).code, 2) << to;
    EXPECT_EQ(shell(fmt::format("\"$ccdfuzz\" {}", to)).code, 2) << to;
  }
  succeeded(shell("\"$ccdfuzz\" hunt --cases 1 --methods tdibm-c --linear --corpus " +
                  folder / "finds" + " <&- 2>&-"));
}

TEST(StandardStreams, AClosedStdoutIsAnError) {
  refused(shell("\"$ccdfuzz\" methods >&-"), "stdout: cannot write");
}

TEST(StandardStreams, NoFileTakesThePlaceOfAClosedStream) {
  const ScratchFolder folder;
  const std::string set = folder / "p.jsonl";
  const std::string line =
      fmt::format("\"$ccdfuzz\" generate --paper --one-in 400 --threads 1 -o {}", set);
  // Interrupted, then run again with nowhere to say that it resumes.
  shell("timeout -s INT 1 " + line);
  shell("timeout -s INT 1 " + line + " 2>&-");
  EXPECT_EQ(shell("grep -c 'going on behind' " + set + ".partial").code,
            std::filesystem::exists(set + ".partial") ? 1 : 2);
}

TEST(StandardStreams, AFileThatGrowsTooLargeIsAnErrorThatLeavesNothing) {
  const ScratchFolder folder;
  refused(shell(fmt::format(
              "ulimit -f 1; \"$ccdfuzz\" generate --contact VV --kind RP --count 40 -o {}",
              folder / "g.jsonl")),
          "cannot write: File too large");
  EXPECT_EQ(folder.entry_count(), 0U);
}

TEST(OddFiles, AreErrorsInWords) {
  const ScratchFolder folder;
  const std::string loop = folder / "loop", good = generated(folder, "VV", "RP", 1);
  std::filesystem::create_symlink("loop", loop);
  const std::string long_name(300, 'x'), long_path = std::string(6000, '/') + "x";
  for (const std::string& input : {loop, long_name + ".jsonl", long_path + ".jsonl"}) {
    const Finished finished =
        shell(fmt::format("\"$ccdfuzz\" merge {} {} -o {}", input, good, folder / "m.jsonl"));
    EXPECT_EQ(finished.code, 2) << finished.err;
    EXPECT_THAT(finished.err, testing::Not(HasSubstr("internal error")));
  }
  const Finished linear = shell("timeout 60 \"$ccdfuzz\" evaluate /proc");
  EXPECT_EQ(linear.code, 2) << linear.err;
  EXPECT_THAT(linear.err, testing::Not(HasSubstr("internal error")));
}

TEST(OddFiles, AreRefusedWhenTheyDoNotEnd) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 1), csv = folder / "q.csv";
  write_text(csv, "0,1,0,1,0,1\n");
  for (const std::string& line :
       {fmt::format("import {} --as edge-edge --truths /dev/zero -o {}", csv, folder / "i.jsonl"),
        fmt::format("report {} --scoreboard /dev/zero -o {}", set, folder / "r")}) {
    refused(shell("ulimit -v 1000000; timeout -k 5 20 \"$ccdfuzz\" " + line),
            "/dev/zero: is longer than");
  }
}

TEST(OddNames, ReachNoTerminalRaw) {
  const ScratchFolder folder;
  const std::string bad = folder / "a\x1b]0;b";
  std::filesystem::create_directories(bad);
  const std::string set = generated(folder, "VV", "RP", 2);
  const std::vector<std::vector<std::string>> commands = {
      {"triage", bad, "-o", folder / "t"},
      {"merge", set, "-o", bad + "/m.jsonl"},
      {"generate", "--paper", "--one-in", "4000", "-o", bad + "/p.jsonl"},
      {"hunt", "--cases", "1", "--linear", "--methods", "tdibm-c", "--corpus", bad + "/c",
       "--report", bad + "/r"},
  };
  for (const auto& command : commands) {
    const Finished finished = ccdfuzz(command);
    EXPECT_EQ((finished.out + finished.err).find('\x1b'), std::string::npos)
        << testing::PrintToString(command) << finished.out << finished.err;
  }
}

TEST(OddOptions, AnEmptyNameIsRefusedByItsOption) {
  const std::vector<std::vector<std::string>> commands = {{"prove", "x.json"},  {"merge", "x.json"},
                                                          {"import", "x.csv"},  {"triage", "x"},
                                                          {"export", "x.json"}, {"report", "x"}};
  for (const auto& command : commands) {
    const Finished finished = refused(ccdfuzz(with(command, {"-o", ""})), "-o");
    EXPECT_THAT(finished.err, HasSubstr("is empty")) << testing::PrintToString(command);
  }
}

}  // namespace
}  // namespace ccdfuzz
