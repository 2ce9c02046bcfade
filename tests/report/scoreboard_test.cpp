#include "report/scoreboard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scratch_folder.hpp"

namespace ccdfuzz {
namespace {

using testing::HasSubstr;

const std::string kBoard = CCDFUZZ_SOURCE_DIR "/tests/scoreboard/results.json";

TEST(Scoreboard, ReadsTheOneThatStandsInTheRepository) {
  const Result<Scoreboard> board = read_scoreboard(kBoard);
  ASSERT_TRUE(board) << board.error().message();
  ASSERT_FALSE(board->drivers.empty());
  for (const ScoreboardDriver& driver : board->drivers) {
    std::uint64_t faults = 0, killed = 0;
    for (const ScoreboardRow& row : board->rows) {
      if (row.driver != driver.driver || row.equivalent || row.fault == "none") continue;
      ++faults;
      killed += row.is_kill() ? 1 : 0;
    }
    EXPECT_EQ(faults, driver.faults) << driver.driver;
    EXPECT_EQ(killed, driver.killed) << driver.driver;
  }
}

/// A board of one driver and one fault.
const std::string kSmallBoard = R"({"format": "ccdfuzz-scoreboard", "version": 1,
  "drivers": [{"driver": "hunt", "faults": 7, "reached": 6, "triggered": 6, "killed": 4,
    "clean_runs": 1, "false_alarms": 0, "seconds": 0.1, "executions": 11, "mean_seconds": 0.2,
    "censored": false}],
  "rows": [{"driver": "hunt", "fault": "end.sign", "what": "a sign", "equivalent": false, "runs": 3,
    "reached": 3, "triggered": 3, "detected": 2, "seconds": 0.5, "executions": 9, "limit": 2,
    "found": "x"}]})";

TEST(Scoreboard, RefusesWhatIsNoneNamingFileFieldAndValue) {
  const ScratchFolder folder;
  const std::string path = folder / "board.json";
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = kSmallBoard;
    text.replace(text.find(from), from.size(), to);
    write_text(path, text);
    const Result<Scoreboard> board = read_scoreboard(path);
    return board ? std::string() : board.error().message();
  };
  EXPECT_EQ(refusal("hunt", "hunt"), "");
  EXPECT_EQ(refusal("\"faults\": 7", "\"faults\": -7"),
            path + ": drivers[0].faults: -7 is not a whole number from 0 on");
  EXPECT_THAT(refusal("\"killed\": 4", "\"killed\": 8"), HasSubstr("drivers[0].killed: 8 is more"));
  EXPECT_THAT(refusal("\"limit\": 2", "\"limit\": \"2\""), HasSubstr("rows[0].limit: \"2\" is"));
  EXPECT_THAT(refusal("\"ccdfuzz-scoreboard\"", "\"x\""), HasSubstr("format: \"x\" is not"));
  EXPECT_THAT(refusal("\"censored\": false", "\"censored\": 0"), HasSubstr("censored: 0 is"));
  EXPECT_THAT(refusal("\"driver\"", "\"drover\""), HasSubstr("has no \"driver\""));
  EXPECT_THAT(refusal("{", "["), HasSubstr(path));
  EXPECT_FALSE(read_scoreboard(folder / "nothing.json"));
}

}  // namespace
}  // namespace ccdfuzz
