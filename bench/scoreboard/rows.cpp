#include "rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "bench/median.hpp"
#include "io/output_file.hpp"

namespace ccdfuzz {

namespace {

/// What was measured until something was noticed, or until the end without that.
struct Measured {
  double value = 0;
  bool is_whole = false;  ///< noticed
};

/// What was not noticed took longer than all that was, whatever its limit. Where the median is of
/// such, it is the least that the ends leave.
double median_of(const std::vector<Measured>& all, bool is_whole) {
  std::vector<double> values;
  for (const Measured& m : all) {
    const bool last = is_whole && !m.is_whole;
    values.push_back(last ? std::numeric_limits<double>::infinity() : m.value);
  }
  return median(std::move(values));
}

Row row_of(const std::vector<const Record*>& runs) {
  Row row;
  std::vector<Measured> seconds, executions;
  row.limit = std::numeric_limits<double>::infinity();
  for (const Record* r : runs) {
    ++row.runs;
    row.reached += r->reached > 0 || r->detected ? 1 : 0;
    row.triggered += r->triggered > 0 || r->detected ? 1 : 0;
    row.detected += r->detected ? 1 : 0;
    if (r->detected && row.found.empty()) row.found = r->found;
    row.watched += r->watched ? 1 : 0;
    if (!r->detected) {
      row.limit = std::min(row.limit, r->limit);
      row.most = std::max(row.most, r->limit);
    }
    seconds.push_back({r->detected ? r->seconds : r->limit, r->detected});
    executions.push_back({static_cast<double>(r->executions), r->detected});
  }
  if (row.detected == row.runs) row.limit = 0;
  row.seconds = median_of(seconds, row.is_kill());
  row.executions = median_of(executions, row.is_kill());
  return row;
}

/// Under the table of drivers.
constexpr const char* kLegend =
    R"(
`random`: random patches. `rapidcheck`: its own arbitrary doubles. `contacts`: whole queries of
generated contacts. `traces`: their witnesses followed through the methods. `corpus`: the stored
counterexamples, traced and asked, each once. `by-chance`: contacts, traces, and mutants bred by
chance. `hunt`: the same, bred by margins. `properties`: every property that holds, on draws of its
own. What the fuzz targets notice stands in targets.md.

Times are medians over the seeds, and over the faults: a run that did not notice counts as longer than
all that did, whatever its limit; where the median is of such, it is at least (≥) that. Each
cell below is the median time to a kill, "missed" (in some run the fault's wrong value differed from
the right one, and nothing was noticed), "not triggered" (it was computed and never differed), "not
reached", or empty where nothing was measured; (3 of 5) is the share of seeds that noticed. Except
for properties, which come in turn by the time that they take, a driver first runs with each seed on
the right sources up to its limit, then again for as many executions with all faults watched: where
a wrong value would never have differed, a run with that fault takes the same course, and needs no
run of its own. A fault that is a statement counts as triggered where it is reached. The CPU times
are of a machine with other work on it.
)";

/// The rows of PREFIX.json.
struct Board {
  std::vector<DriverRow> drivers;
  std::vector<Row> rows;

  static void fields(auto& archive, auto& board) {
    archive.format("ccdfuzz-scoreboard", 1, 1);
    archive("drivers", board.drivers);
    archive("rows", board.rows);
  }
};

std::string range(double least, double most) {
  return least < most ? fmt::format("{}–{}", least, most) : fmt::format("{}", most);
}

/// The median time to a kill, or what kept the fault from being noticed.
std::string cell(const Row& row) {
  const std::string of_runs = row.detected == row.runs || row.detected == 0
                                  ? ""
                                  : fmt::format(" ({} of {})", row.detected, row.runs);
  if (row.is_kill()) return duration_text(row.seconds) + of_runs;
  if (row.reached == 0) return "not reached";
  if (row.triggered == 0) return "not triggered";
  return "missed" + of_runs;
}

std::string markdown(const std::vector<PlantedFault>& faults, const std::vector<Row>& rows) {
  std::ostringstream out;
  const std::vector<DriverRow> drivers = driver_rows(rows);
  out << driver_table(drivers).to_markdown() << kLegend;
  out << "\n| fault | |";
  for (const DriverRow& d : drivers) out << " `" << d.driver << "` |";
  out << "\n|---|---|";
  for (std::size_t i = 0; i < drivers.size(); ++i) out << "---|";
  out << '\n';
  for (const PlantedFault& fault : faults) {
    out << fmt::format("| `{}` | {}{} |", fault.name, fault.what,
                       fault.equivalent.empty() ? "" : " (equivalent)");
    for (const DriverRow& d : drivers) {
      const auto row = std::ranges::find_if(
          rows, [&](const Row& r) { return r.driver == d.driver && r.fault == fault.name; });
      if (row == rows.end()) {
        out << " |";
      } else {
        out << ' ' << cell(*row) << " |";
      }
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace

Table driver_table(const std::vector<DriverRow>& drivers) {
  Table table({{"driver", Align::kLeft},
               {"killed"},
               {"reached"},
               {"triggered"},
               {"decided by the watched run"},
               {"seeds"},
               {"limit"},
               {"median time"},
               {"mean time"},
               {"median executions"},
               {"false alarms"}});
  for (const DriverRow& d : drivers) {
    const char* at_least = d.censored ? "≥ " : "";
    table.add_row({{d.driver},
                   {fmt::format("{} of {}", d.killed, d.faults)},
                   {fmt::format("{}", d.reached)},
                   {fmt::format("{}", d.triggered)},
                   {fmt::format("{}", d.watched)},
                   {range(static_cast<double>(d.least_runs), static_cast<double>(d.most_runs))},
                   {d.most_limit == 0 ? "none was met" : range(d.limit, d.most_limit) + " s"},
                   {at_least + duration_text(d.seconds)},
                   {duration_text(d.mean_seconds)},
                   {fmt::format("{}{:.0f}", at_least, d.executions)},
                   {fmt::format("{} of {}", d.false_alarms, d.clean_runs)}});
  }
  return table;
}

std::vector<Row> rows_of(const std::vector<PlantedFault>& faults, const Records& records) {
  std::vector<Row> rows;
  for (const Driver driver : kDrivers) {
    for (std::size_t f = 0; f <= faults.size(); ++f) {
      const std::string name = f == 0 ? kNoFault : faults[f - 1].name;
      std::vector<const Record*> runs;
      for (const auto& [key, record] : records.all()) {
        if (record.driver == driver && record.fault == name) runs.push_back(&record);
      }
      if (runs.empty()) continue;
      rows.push_back(row_of(runs));
      rows.back().driver = name_of(driver);
      rows.back().fault = name;
      if (f > 0) rows.back().what = faults[f - 1].what;
      rows.back().equivalent = f > 0 && !faults[f - 1].equivalent.empty();
    }
  }
  return rows;
}

std::vector<DriverRow> driver_rows(const std::vector<Row>& rows) {
  std::vector<DriverRow> out;
  for (const Driver driver : kDrivers) {
    DriverRow d;
    d.driver = name_of(driver);
    std::vector<Measured> seconds, executions;
    for (const Row& row : rows) {
      if (row.driver != d.driver || row.equivalent) continue;
      if (row.fault == kNoFault) {
        d.clean_runs = row.runs, d.false_alarms = row.detected;
        continue;
      }
      ++d.faults;
      d.reached += row.reached > 0 ? 1 : 0;
      d.triggered += row.triggered > 0 ? 1 : 0;
      d.killed += row.is_kill() ? 1 : 0;
      d.watched += row.watched == row.runs ? 1 : 0;
      d.least_runs = d.faults == 1 ? row.runs : std::min(d.least_runs, row.runs);
      d.most_runs = std::max(d.most_runs, row.runs);
      if (row.detected < row.runs) {
        d.limit = d.most_limit == 0 ? row.limit : std::min(d.limit, row.limit);
        d.most_limit = std::max(d.most_limit, row.most);
      }
      seconds.push_back({row.seconds, row.is_kill()});
      executions.push_back({row.executions, row.is_kill()});
      d.mean_seconds += row.seconds;
    }
    if (d.faults == 0) continue;
    d.mean_seconds /= static_cast<double>(d.faults);
    d.censored = 2 * d.killed <= d.faults;
    d.seconds = median_of(seconds, !d.censored);
    d.executions = median_of(executions, !d.censored);
    out.push_back(d);
  }
  return out;
}

Result<void> probe_tables(const std::string& prefix) {
  for (const char* ending : {".md", ".json"}) {
    CCDFUZZ_TRY_VOID(OutputFile::create(prefix + ending));
  }
  return {};
}

Result<void> write_tables(const std::string& prefix, const std::vector<PlantedFault>& faults,
                          const Records& records) {
  const std::vector<Row> rows = rows_of(faults, records);
  CCDFUZZ_TRY_VOID(write_file(prefix + ".md", markdown(faults, rows)));
  const Board board{driver_rows(rows), rows};
  return write_file(prefix + ".json", readable_json(to_json(board)) + '\n');
}

}  // namespace ccdfuzz
