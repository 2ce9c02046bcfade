#pragma once

#include <string>
#include <vector>

#include "fault_list.hpp"
#include "io/fields.hpp"
#include "io/table.hpp"
#include "records.hpp"

namespace ccdfuzz {

/// What the runs of one driver against one fault say together. Times and executions are medians
/// over the runs. A run that did not detect the fault counts as longer than all that did, whatever
/// its limit. If the median is such a run, it is a lower bound ("censored").
struct Row {
  std::string driver, fault;  ///< fault "none": false alarms
  std::string what;           ///< the fault in words
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

  static void fields(auto& archive, auto& row) {
    archive("driver", row.driver);
    archive("fault", row.fault);
    archive("what", row.what);
    archive("equivalent", row.equivalent);
    archive("runs", row.runs);
    archive("watched", row.watched);
    archive("reached", row.reached);
    archive("triggered", row.triggered);
    archive("detected", row.detected);
    archive("seconds", row.seconds);
    archive("executions", row.executions);
    archive("limit", row.limit);
    archive("most", row.most);
    archive("found", row.found);
  }
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

  static void fields(auto& archive, auto& row) {
    archive("driver", row.driver);
    archive("faults", row.faults);
    archive("reached", row.reached);
    archive("triggered", row.triggered);
    archive("killed", row.killed);
    archive("watched", row.watched);
    archive("clean_runs", row.clean_runs);
    archive("false_alarms", row.false_alarms);
    archive("least_runs", row.least_runs);
    archive("most_runs", row.most_runs);
    archive("limit", row.limit);
    archive("most_limit", row.most_limit);
    archive("seconds", row.seconds);
    archive("executions", row.executions);
    archive("mean_seconds", row.mean_seconds);
    archive("censored", row.censored);
  }
};

/// All rows that there are records of: driver by driver, no fault first, then as in the list.
std::vector<Row> rows_of(const std::vector<PlantedFault>& faults, const Records& records);
std::vector<DriverRow> driver_rows(const std::vector<Row>& rows);

/// A row a driver: how many faults it noticed, and how soon.
Table driver_table(const std::vector<DriverRow>& drivers);

/// Writes PREFIX.md, the drivers and then a line a fault with the median time of each driver.
/// Writes PREFIX.json:
///   {"format": "ccdfuzz-scoreboard", "version": 1, "drivers": [DriverRow, …], "rows": [Row, …]}
/// Each appears complete or not at all.
Result<void> write_tables(const std::string& prefix, const std::vector<PlantedFault>& faults,
                          const Records& records);

/// Errors: write_tables could not write there. Leaves nothing.
Result<void> probe_tables(const std::string& prefix);

}  // namespace ccdfuzz
