// Starts the real scoreboard; what needs no process is tested in its parts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.hpp"

namespace ccdfuzz {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTrackedRecords = CCDFUZZ_SOURCE_DIR "/bench/scoreboard/records.jsonl";

Finished run(const std::vector<std::string>& arguments) {
  return Process(arguments).wait();
}

TEST(ScoreboardCommand, RefusesWhatItCannotRun) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--drivers", "nosuch"}, "--drivers: no driver \"nosuch\"; there are: random, "},
      {{"--faults", "nosuch"}, "--faults: no fault \"nosuch\""},
      {{"--seeds", "0"}, "--seeds: \"0\" is not a whole number from 1 to "},
      {{"--seeds", "-1"}, "--seeds: \"-1\" is not a whole number"},
      {{"--weak-seeds", "0"}, "--weak-seeds: \"0\" is not a whole number from 1 to "},
      {{"--only-seed", "0"}, "--only-seed: \"0\" is not a whole number from 1 to "},
      {{"--only-seed", "1", "--seeds", "2"}, "--seeds excludes --only-seed"},
      {{"--seconds", "nan"}, "--seconds: \"nan\" is not a number"},
      {{"--seconds", "-1"}, "--seconds: -1 is not in (0, 1000000000]"},
      {{"--weak-seconds", "0"}, "--weak-seconds: 0 is not in (0, 1000000000]"},
      {{"--seconds", "1e300"}, "--seconds: 1e300 is not in (0, 1000000000]"},
      {{"--tables", "/nosuch/t"}, "/nosuch/t.md: cannot write: "},
      {{"--records", "/nosuch/r"}, "/nosuch/r: cannot write: "},
      {{"--no-runs"}, "--no-runs requires --records"},
      {{"--no-runs", "--records", "/nosuch/r"}, "/nosuch/r: cannot read: "},
      {{"--no-runs", "--records", "/dev/null"}, "/dev/null: is not a regular file"},
      {{"--no-runs", "--records", kTrackedRecords, "--seeds", "1"}, "excludes --no-runs"}};
  for (const auto& [arguments, message] : wrong) {
    const Finished refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << message;
    EXPECT_THAT(refused.err, HasSubstr(message));
    EXPECT_EQ(refused.out, "");
  }
}

TEST(ScoreboardCommand, PrintsAndWritesWhatRecordsSayWithoutRunning) {
  const ScratchFolder folder;
  const Finished done = run({"--no-runs", "--records", kTrackedRecords, "--tables", folder / "t"});
  EXPECT_EQ(done.code, 0) << done.err << done.out;
  EXPECT_THAT(done.out, AllOf(StartsWith("driver"), HasSubstr("\nproperties ")));
  EXPECT_EQ(folder.entry_count(), 2);
  EXPECT_THAT(read_text(folder / "t.md"), StartsWith("| driver |"));
}

TEST(ScoreboardCommand, TellsWhatIsWrongInRecords) {
  const ScratchFolder folder;
  write_text(folder / "r",
             R"({"format":"ccdfuzz-run","version":1,"run":"scoreboard","ccdfuzz":"","inputs":[],)"
             R"("asked":{},"items":0,"shard":{"index":0,"of":1}})"
             "\n"
             R"({"driver":"hunt","fault":"tdibm.stale_window","seed":2,"limit":10.0,"reached":1,)"
             R"("triggered":1,"detected":true,"executions":1,"seconds":0.5,"found":"x",)"
             R"("watched":false})"
             "\n");
  const Finished done = run({"--no-runs", "--records", folder / "r"});
  EXPECT_EQ(done.code, 1);
  EXPECT_THAT(done.out, HasSubstr("\nequivalent, but noticed: tdibm.stale_window by hunt seed 2"));
}

TEST(ScoreboardCommand, GoesOnWhereItWasKilled) {
  const ScratchFolder folder;
  const std::string path = folder / "r";
  const std::vector<std::string> all = {"--drivers",      "properties,corpus",
                                        "--faults",       "product.sign,bound.zero",
                                        "--seeds",        "2",
                                        "--seconds",      "1",
                                        "--weak-seconds", "1",
                                        "--records",      path};
  {
    Process killed(all);
    const auto is_begun = [&] { return size_or_zero(path) > 500; };
    killed.wait_until(is_begun);
    ASSERT_TRUE(is_begun());
  }
  const std::uintmax_t size = std::filesystem::file_size(path);
  const Finished done = run(all);
  EXPECT_EQ(done.code, 0) << done.err << done.out;
  EXPECT_EQ(folder.entry_count(), 1);
  EXPECT_GT(std::filesystem::file_size(path), size);
  const std::string text = read_text(path);
  for (const char* start : {R"({"driver":"properties","fault":"none","seed":1,)",
                            R"({"driver":"properties","fault":"bound.zero","seed":2,)",
                            R"({"driver":"corpus","fault":"product.sign","seed":1,)"}) {
    const std::size_t at = text.find(start);
    EXPECT_NE(at, text.npos) << start;
    EXPECT_EQ(text.find(start, at + 1), text.npos) << start;
  }
}

TEST(ScoreboardCommand, TellsOfTheFaultsThatWereAskedForAlone) {
  const ScratchFolder folder;
  const Finished done =
      run({"--drivers", "traces", "--faults", "bound.zero", "--only-seed", "1", "--weak-seconds",
           "0.5", "--verbose", "--tables", folder / "t", "--records", folder / "r"});
  EXPECT_NE(done.code, 2) << done.err;
  std::istringstream lines(done.out);
  int runs = 0;
  for (std::string line; std::getline(lines, line) && !line.starts_with("driver"); ++runs) {
    EXPECT_THAT(line, testing::ContainsRegex("^traces +(none|watched|bound.zero) ")) << line;
  }
  EXPECT_GE(runs, 2) << done.out;
  EXPECT_THAT(done.out, testing::ContainsRegex("\ntraces +[01] of 1 ")) << done.out;
  const auto tables = nlohmann::json::parse(read_text(folder / "t.json"));
  EXPECT_EQ(tables["rows"].size(), 2U) << tables;
}

TEST(ScoreboardCommand, RunsOnTheRightSourcesAlone) {
  const Finished done = run({"--drivers", "properties", "--faults", "none", "--only-seed", "9",
                             "--seconds", "0.2", "--verbose"});
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_THAT(done.out, StartsWith("properties    none                                 9 - ("));
}

}  // namespace
}  // namespace ccdfuzz
