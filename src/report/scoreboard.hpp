#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "numeric/result.hpp"

namespace ccdfuzz {

/// How soon one driver detects one planted fault: medians over its runs, where one that did not
/// detect it counts as longer than all that did; if that is the median, it is at least so much.
struct ScoreboardRow {
  std::string driver, fault, what;
  bool equivalent = false;  ///< the fault changes nothing that could be noticed
  std::uint64_t runs = 0, reached = 0, triggered = 0, detected = 0;
  double seconds = 0, executions = 0, limit = 0;  ///< CPU seconds
  std::string found;                              ///< by the first run that detected it

  /// Detected by more than half of the runs.
  bool is_kill() const { return 2 * detected > runs; }
};

/// One driver over all faults that are not equivalent.
struct ScoreboardDriver {
  std::string driver;
  std::uint64_t faults = 0, reached = 0, triggered = 0, killed = 0;
  std::uint64_t clean_runs = 0, false_alarms = 0;
  double seconds = 0, executions = 0, mean_seconds = 0;
  bool censored = false;  ///< the median is that of a miss: it is at least so much
};

/// How the drivers of the tests fare with planted faults, as ccdfuzz-scoreboard --tables wrote it.
struct Scoreboard {
  std::vector<ScoreboardDriver> drivers;
  std::vector<ScoreboardRow> rows;  ///< fault "none": runs on the right sources

  bool empty() const { return drivers.empty() && rows.empty(); }
};

/// Reads a PREFIX.json of ccdfuzz-scoreboard. Errors: naming the file, the field and the value.
Result<Scoreboard> read_scoreboard(const std::string& path);

}  // namespace ccdfuzz
