#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fault_list.hpp"
#include "records.hpp"

namespace ccdfuzz {

/// What the runs of one driver against one fault say together. Times and executions are medians
/// over the runs. A run that did not detect the fault counts as longer than all that did, whatever
/// its limit. If the median is such a run, it is a lower bound ("censored").
struct Row {
  std::string driver, fault;  ///< fault "none": false alarms
  bool equivalent = false;
  std::size_t runs = 0, reached = 0, triggered = 0,
              detected = 0;  ///< all runs, and how many did so
  std::size_t watched = 0;   ///< how many were decided by a run of the right sources
  double seconds = 0, executions = 0;
  double limit = 0,
         most = 0;    ///< CPU seconds, the least and most of the runs that detected nothing
  std::string found;  ///< by the first run that detected it

  /// Detected by more than half of the runs: then the medians are of what was measured.
  bool is_kill() const { return 2 * detected > runs; }
};

/// One row a driver over all faults that are not equivalent.
struct DriverRow {
  std::string driver;
  std::size_t faults = 0, reached = 0, triggered = 0, killed = 0;
  std::size_t clean_runs = 0, false_alarms = 0;
  std::size_t least_runs = 0, most_runs = 0;  ///< against a fault
  double limit = 0, most_limit = 0;           ///< CPU seconds of the runs that detected nothing
  std::size_t watched = 0;                    ///< faults decided without a run of their own
  double seconds = 0, executions = 0;         ///< medians over the faults, misses censored
  double mean_seconds = 0;                    ///< restricted to the limits
  bool censored = false;  ///< the median is that of a miss, and so a lower bound
};

/// All rows that there are records of: driver by driver, no fault first, then as in the list.
std::vector<Row> rows_of(const std::vector<PlantedFault>& faults, const Records& records);
std::vector<DriverRow> driver_rows(const std::vector<Row>& rows);

/// "3.5 ms".
std::string seconds_text(double seconds);

/// Writes PREFIX.csv, a line a row; PREFIX.md, the drivers and then a line a fault with the median
/// time of each driver; PREFIX.json:
///   {"format": "ccdfuzz-scoreboard", "version": 1,
///    "drivers": [{"driver", "faults", "reached", "triggered", "killed", "watched",
///                 "clean_runs", "false_alarms", "least_runs", "most_runs", "limit",
///                 "most_limit", "seconds", "executions", "mean_seconds", "censored"}, …],
///    "rows": [{"driver", "fault", "what", "equivalent", "runs", "watched", "reached",
///              "triggered", "detected", "seconds", "executions", "limit", "most",
///              "found"}, …]}
/// with the fields of DriverRow and Row, "what" being the fault in words. Each appears complete or
/// not at all.
Result<void> write_tables(const std::string& prefix, const std::vector<PlantedFault>& faults,
                          const Records& records);

/// Errors: write_tables could not write there. Leaves nothing.
Result<void> probe_tables(const std::string& prefix);

}  // namespace ccdfuzz
