#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "falling_vertex.hpp"
#include "process.hpp"

namespace ccdfuzz {
namespace {

TEST(Usage, VersionIsPrinted) {
  const Finished version = succeeded(ccdfuzz({"--version"}));
  EXPECT_EQ(version.out.find_first_not_of("0123456789.\n"), std::string::npos) << version.out;
}

struct BadUsage {
  std::vector<std::string> arguments;
  std::string named;  ///< what the message must name
};

TEST(Usage, WrongUseEndsWith2AndNamesWhatIsWrong) {
  const std::vector<std::string> generate = {"generate", "--contact", "VV", "--kind", "RP"};
  std::vector<BadUsage> table = {
      {{}, "no command"},
      {{"--nonsense"}, "--nonsense"},
      {{"query"}, "case"},
      {{"query", "x.json", "--methods", "tdibm-h:nan"}, "\"nan\""},
      {{"query", "x.json", "--methods", "tdibm,tdibm"}, "twice"},
      {{"query", "x.json", "--methods", ""}, "--methods: is empty"},
      {{"query", "x.json", "--precision", "0"}, "0 is not in"},
      {{"query", "x.json", "--precision", "2"}, "2 is not in"},
      {{"query", "x.json", "--precision", "-1"}, "-1"},
      {{"query", "x.json", "--precision", "nan"}, "nan"},
      {{"query", "x.json", "--max-pops", "0"}, "--max-pops"},
      {{"query", "x.json", "--threads", "0"}, "--threads"},
      {{"query", "x.json", "--threads", "two"}, "two"},
      {{"generate"}, "required"},
      {{"generate", "--contact", "XX", "--kind", "RP", "--count", "1"}, "\"XX\""},
      {{"generate", "--contact", "VV", "--kind", "rp", "--count", "1"}, "\"rp\""},
      {with(generate, {"--count", "0"}), "--count"},
      {with(generate, {"--count", "-1"}), "--count"},
      {with(generate, {"--count", "1.5"}), "--count"},
      {with(generate, {"--count", "1", "--seed", "x"}), "--seed"},
      {with(generate, {"--count", "1", "--seed", "010"}), "\"010\""},
      {with(generate, {"--count", "1", "--seed", "-1"}), "\"-1\""},
      {with(generate, {"--count", "1", "--seed", " 5"}), "\" 5\""},
      {with(generate, {"--count", "1", "--seed", "18446744073709551616"}), "18446744073709551616"},
      {with(generate, {"--count", "2", "--first", "18446744073709551615"}), "--first"},
      {with(generate, {"--count", "1", "--eps-t", "1e-6"}), "\"1e-6\""},
      {with(generate, {"--count", "1", "--eps-t", "2^-x"}), "\"2^-x\""},
      {with(generate, {"--count", "1", "--construction", "best"}), "\"best\""},
      {with(generate, {"--count", "1", "-o", "x.txt"}), "x.txt"},
      {with(generate, {"--count", "1", "--json"}), "--json"},
      {with(generate, {"--count", "2", "-o", "/tmp/no-such-folder/x.jsonl"}), "no-such-folder"},
      {{"hunt", "--seconds", "0"}, "--seconds"},
      {{"hunt", "--seconds", "soon"}, "soon"},
      {{"hunt", "--seconds", "nan"}, "nan"},
      {{"hunt", "--seconds", "inf"}, "--seconds"},
      {{"hunt", "--cases", "1000000000000000001"},
       "1000000000000000001 is not in [1, 1000000000000000000]"},
      {{"hunt", "--cases", "18446744073709551615"}, "is not in [1, 1000000000000000000]"},
      {{"hunt", "--shape", "cube:2"}, "--shape"},
      {{"hunt", "--shape", ""}, "--shape"},
      {{"hunt", "--shape", "point", "--linear"}, "--linear"},
      {{"hunt", "--precision", "1e-2"}, "--precision"},
      {{"hunt", "--cases", "0"}, "--cases"},
      {{"hunt", "--cases", "1", "--seconds", "1"}, "--seconds"},
      {{"hunt", "--fail-on", "most"}, "most"},
      {{"hunt", "--methods", "tdibm-h:abc"}, "\"abc\""},
      {{"hunt", "--corpus", "/proc/no-such-folder"}, "/proc/no-such-folder"},
      {{"hunt", "--corpus", "/dev/null/finds"}, "/dev/null/finds"},
      {{"verify"}, "case"},
      {{"trace"}, "case"},
      {{"merge", "-o", "/tmp/all"}, "input"},
      {{"prove", "x.jsonl"}, "--output"},
      {{"prove", "-o", "/tmp/no-case.jsonl"}, "case"},
      {{"evaluate"}, "dataset"},
      {{"check", "dyadic"}, "no property \"dyadic\""},
      {{"check", "--count", "1", "--seconds", "1"}, "--seconds"},
      {{"check", "--seconds", "0"}, "--seconds"},
      {{"check", "--seconds", ""}, "--seconds: is empty"},
      {{"check", "--seconds", "1", "--first", "18446744073709551615"}, "--first"},
      {{"check", "--choices", "0"}, "property"},
      {{"check", "tdibm.separation", "--choices", "x"}, "--choices"},
      {{"check", "--count", "2", "--first", "18446744073709551615"}, "--first"},
      {{"evaluate", "x.jsonl", "--t-max-factors", "0.5"}, "0.5"},
      {{"evaluate", "x.jsonl", "--t-max-factors", "1,,2"}, "\"\""},
      {{"evaluate", "x.jsonl", "--t-max-factors", "1,2,1"}, "twice"},
      {{"evaluate", "x.jsonl", "--t-max-factors", "1+2^-2000"}, "--t-max-factors: \"1+2^-2000\""},
      {{"minimize", CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json", "--method", "nope"},
       "--method: unknown method \"nope\""},
      {{"minimize", CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json", "--method",
        "tdibm-h:x"},
       "--method: "},
      {{"methods", "nope"}, "methods: method: unknown method \"nope\""},
      {{"triage", "no-such-folder"}, "no such file or folder"},
      {{"bench", "--classes", "FF,XX"}, "\"XX\""},
      {{"bench", "--classes", "FF,FF"}, "twice"},
      {{"bench", "--classes", ""}, "--classes: is empty"},
      {{"bench", "--methods", "tdibm-c@unoptimised"}, "--methods"},
      {{"bench", "--construction", "magic"}, "\"magic\""},
      {{"bench", "--count", "0"}, "--count"},
  };
  for (const char* shape : {"blob", "triangle", "triangle:0", "triangle:9", "tensor:2", "curve:2x",
                            "point,", "triangle:2,triangle:2,triangle:2"}) {
    table.push_back({with(generate, {"--count", "1", "--shape", shape}), "--shape"});
  }
  for (const char* option : {"--seconds", "--count", "--seed", "--first", "--threads"}) {
    table.push_back({{"check", "dyadic.round_trip", "--choices", "0", option, "5"}, option});
  }
  for (const BadUsage& bad : table) {
    const Finished finished = ccdfuzz(bad.arguments);
    const std::string shown = testing::PrintToString(bad.arguments);
    EXPECT_EQ(finished.code, 2) << shown << "\n" << finished.err;
    EXPECT_THAT(finished.err, testing::HasSubstr(bad.named)) << shown;
    EXPECT_EQ(finished.out, "") << shown;
  }
}

/// "ccdfuzz: COMMAND: object: problem", on one line.
void expect_one_error(const std::vector<std::string>& arguments, const std::string& accepted) {
  const Finished finished = ccdfuzz(arguments);
  const std::string shown = testing::PrintToString(arguments) + "\n" + finished.err;
  EXPECT_EQ(finished.code, 2) << shown;
  EXPECT_THAT(finished.err, testing::StartsWith("ccdfuzz: " + arguments.front() + ": ")) << shown;
  EXPECT_THAT(finished.err, testing::HasSubstr(accepted)) << shown;
  EXPECT_EQ(std::ranges::count(finished.err, '\n'), 1) << shown;
}

TEST(Usage, WhatIsNoCaseIsNamedWithWhatIsAccepted) {
  const ScratchFolder folder, queries;
  const std::string good = read_text(CCDFUZZ_SOURCE_DIR "/corpus/cases/tdibm-e-underflow.json");
  const std::vector<std::pair<std::string, std::string>> bad = {
      {folder / "missing.json", "No such file"},
      {folder / "empty.json", "is empty; JSON"},
      {folder / "cut.json", "expected"},
      {folder / "junk.json", "JSON is accepted"},
      {queries / "vertex-face.csv", ".csv:8: column 2 (xd): \"0\" is not > 0"}};
  write_text(bad[1].first, "");
  write_text(bad[2].first, good.substr(0, good.size() / 2));
  write_text(bad[3].first,
             "\x7f"
             "ELF\x01\x02");
  std::string csv = falling_vertex("-1,2", 1);
  write_text(bad[4].first, csv.replace(csv.rfind("1,1,0"), 3, "1,0"));
  const std::string out = folder / "out";
  const std::vector<std::vector<std::string>> commands = {
      {"query"},
      {"trace"},
      {"evaluate"},
      {"verify"},
      {"prove", "-o", out + ".jsonl"},
      {"replay"},
      {"export", "--as", "gtest", "-o", out + ".cpp"},
      {"minimize", "--method", "tdibm"}};
  for (const auto& command : commands) {
    for (const auto& [file, accepted] : bad) {
      std::vector<std::string> line = command;
      line.push_back(file);
      expect_one_error(line, accepted);
    }
    if (command.front() == "replay") continue;
    std::vector<std::string> line = command;
    line.push_back(folder.path());
    expect_one_error(line, "accepted are such folders, and files of cases: .json");
  }
  expect_one_error({"import", bad[4].first, "-o", out + ".jsonl"}, bad[4].second);
}

TEST(Usage, UnknownOptionsAreNamedByEveryCommand) {
  for (const std::string& command : commands()) {
    expect_one_error({command, "--frobnicate"},
                     "--frobnicate: no such option; ccdfuzz " + command + " --help lists them");
  }
}

TEST(Usage, APageThatCannotBeWrittenIsRefusedBeforeTheWork) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 1);
  expect_one_error({"hunt", "--cases", "1", "--corpus", folder / "finds", "--report", "/proc/page"},
                   "/proc/page: cannot make the folder");
  expect_one_error({"evaluate", set, "--report", "/proc/page"},
                   "/proc/page: cannot make the folder");
}

TEST(Usage, AFullDiskUnderStdoutIsAnErrorForEveryCommandThatPrints) {
  const ScratchFolder folder;
  const std::string set = generated(folder, "VV", "RP", 3);
  const std::vector<std::vector<std::string>> commands = {
      {"methods"},
      {"methods", "--json"},
      {"query", set},
      {"query", set, "--json"},
      {"evaluate", set},
      {"verify", set},
      {"verify", set, "--json"},
      {"prove", set, "-o", folder / "proven.jsonl"},
      {"prove", set, "-o", folder / "proven.jsonl", "--json"},
      {"hunt", "--cases", "1", "--methods", "tdibm", "--max-pops", "10", "--corpus",
       folder / "finds"},
      {"generate", "--contact", "VV", "--kind", "RP", "--count", "3"},
      {"--help"},
      {"hunt", "--help"},
  };
  for (const auto& command : commands) {
    refused(ccdfuzz(command, "/dev/full"), "No space left on device");
  }
}

TEST(Usage, QuotesControlCharactersSoThatNoTerminalObeysThem) {
  const Finished refused = ccdfuzz({"query", "no\x1b[2Jsuch.json"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, testing::Not(testing::HasSubstr("\x1b")));
  EXPECT_THAT(refused.err, testing::HasSubstr("no\\u001b[2Jsuch.json"));
}

}  // namespace
}  // namespace ccdfuzz
