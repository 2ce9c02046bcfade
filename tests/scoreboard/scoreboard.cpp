// Faults against drivers: which driver notices which fault, and how soon. Each run is a process of
// its own, so that a fault that crashes or hangs is noticed too, and no run depends on another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "drivers.hpp"
#include "eval/table.hpp"
#include "fault_list.hpp"
#include "records.hpp"
#include "rows.hpp"

namespace ccdfuzz {
namespace {

struct Options {
  std::vector<std::string> drivers, faults;
  std::uint64_t seeds = 5, weak_seeds = 3;
  double seconds = 60, weak_seconds = 10;
  std::string records, tables;
  bool verbose = false;
};

/// A row a driver: how many faults it noticed, and how soon; misses count as the limit.
void print_summary(const std::vector<DriverRow>& drivers) {
  Table table({{"driver", Align::kLeft},
               {"faults"},
               {"reached"},
               {"triggered"},
               {"killed"},
               {"median time"},
               {"median executions"},
               {"mean time"},
               {"false alarms"}});
  for (const DriverRow& d : drivers) {
    const char* at_least = d.censored ? ">= " : "";
    table.add_row({{d.driver},
                   {fmt::format("{}", d.faults)},
                   {fmt::format("{}", d.reached)},
                   {fmt::format("{}", d.triggered)},
                   {fmt::format("{}", d.killed)},
                   {at_least + seconds_text(d.seconds)},
                   {fmt::format("{}{:.0f}", at_least, d.executions)},
                   {seconds_text(d.mean_seconds)},
                   {fmt::format("{} of {}", d.false_alarms, d.clean_runs)}});
  }
  std::cout << table.to_text(false);
}

/// The faults that neither our properties nor the hunt noticed in any run.
std::vector<std::string> survivors(const std::vector<Fault>& faults, const Records& records) {
  std::vector<std::string> out;
  for (const Fault& fault : faults) {
    if (!fault.equivalent.empty()) continue;
    bool asked = false, killed = false;
    for (const auto& [key, record] : records.all()) {
      if (record.fault != fault.name) continue;
      if (record.driver != "properties" && record.driver != "hunt") continue;
      asked = true;
      killed = killed || record.detected;
    }
    if (asked && !killed) out.push_back(fault.name);
  }
  return out;
}

bool wanted(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Runs what is not in the records yet. Returns an exit code: 1 after a false alarm.
int campaign(const Options& options, const std::vector<Fault>& faults, Records& records) {
  int code = 0;
  // Seed by seed: a campaign that is stopped has something of every fault.
  for (std::uint64_t seed = 1; seed <= std::max(options.seeds, options.weak_seeds); ++seed) {
    for (const Driver driver : kDrivers) {
      const std::string driver_name(name_of(driver));
      const double limit = is_weak(driver) ? options.weak_seconds : options.seconds;
      if (seed > (is_weak(driver) ? options.weak_seeds : options.seeds)) continue;
      if (!wanted(options.drivers, driver_name) || !is_built(driver)) continue;
      for (std::size_t f = 0; f <= faults.size(); ++f) {
        const std::string fault = f == 0 ? kNoFault : faults[f - 1].name;
        if (f > 0 && !wanted(options.faults, fault)) continue;
        if (records.find(driver_name, fault, seed, limit) != nullptr) continue;
        const Report report = run_apart(static_cast<int>(f), limit, [&](const auto& done) {
          drive(driver, seed, limit, done);
        });
        const Record record{driver_name,
                            fault,
                            seed,
                            limit,
                            report.reached,
                            report.triggered,
                            report.executions,
                            report.detected,
                            report.seconds,
                            report.found};
        if (const auto added = records.add(record); !added) {
          std::cerr << added.error().message() << '\n';
          return 2;
        }
        if (f == 0 && report.detected) {
          code = 1;
          std::cout << "false alarm: " << driver_name << " seed " << seed << ": " << report.found
                    << '\n';
        }
        if (options.verbose) {
          std::cout << fmt::format("{:13} {:36} {} {:>9} {:>8} {}\n", driver_name, fault, seed,
                                   report.detected ? seconds_text(report.seconds) : "missed",
                                   report.executions, report.found)
                    << std::flush;
        }
      }
    }
  }
  return code;
}

int run_all(const Options& options) {
  const auto faults = read_faults(CCDFUZZ_FAULTS);
  if (!faults) {
    std::cerr << faults.error().message() << '\n';
    return 2;
  }
  auto records = Records::open(options.records);
  if (!records) {
    std::cerr << records.error().message() << '\n';
    return 2;
  }
  const int code = campaign(options, *faults, *records);
  if (code == 2) return code;
  print_summary(driver_rows(rows_of(*faults, *records)));
  if (!options.tables.empty()) {
    if (const auto written = write_tables(options.tables, *faults, *records); !written) {
      std::cerr << written.error().message() << '\n';
      return 2;
    }
  }
  const std::vector<std::string> left = survivors(*faults, *records);
  for (const std::string& name : left) std::cout << "not noticed: " << name << '\n';
  return left.empty() ? code : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  CLI::App app{
      "Plants faults one at a time and measures how soon each driver notices. Exits 1 on a "
      "false alarm, or if a fault is left that neither properties nor hunt notice."};
  Options options;
  app.add_option("--drivers", options.drivers,
                 "random, rapidcheck, libfuzzer-raw, libfuzzer, properties, hunt; by default all "
                 "that this build has: libFuzzer needs clang and CCDFUZZ_FUZZ")
      ->delimiter(',');
  app.add_option("--faults", options.faults, "Names; by default all")->delimiter(',');
  app.add_option("--seeds", options.seeds, "Runs of each driver against each fault");
  app.add_option("--seconds", options.seconds, "CPU time of a run");
  app.add_option("--weak-seeds", options.weak_seeds,
                 "The same of random, rapidcheck, libfuzzer-raw");
  app.add_option("--weak-seconds", options.weak_seconds, "The same of these three");
  app.add_option("--tables", options.tables,
                 "Writes what the records say to PREFIX.csv, PREFIX.md and PREFIX.json");
  app.add_option("--records", options.records,
                 "File of what is known already; a campaign that stopped goes on from it");
  app.add_flag("--verbose", options.verbose, "A line a run");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return run_all(options);
}
