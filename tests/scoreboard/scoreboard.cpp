// Faults against drivers: which driver notices which fault, and how soon. Each run is a process of
// its own, so that a fault that crashes or hangs is noticed too, and no run depends on another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "campaign.hpp"
#include "eval/table.hpp"
#include "fault_list.hpp"
#include "records.hpp"
#include "rows.hpp"

namespace ccdfuzz {
namespace {

struct Options : CampaignOptions {
  std::string records, tables;
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

int run_all(const Options& options) {
  const auto faults = read_faults(CCDFUZZ_FAULTS);
  if (!faults) {
    std::cerr << faults.error().message() << '\n';
    return 2;
  }
  if (!options.tables.empty()) {
    if (const auto probed = probe_tables(options.tables); !probed) {
      std::cerr << probed.error().message() << '\n';
      return 2;
    }
  }
  auto records = Records::open(options.records, *faults, Records::Use::kExtend);
  if (!records) {
    std::cerr << records.error().message() << '\n';
    return 2;
  }
  if (const std::size_t outdated = records->outdated(); outdated > 0) {
    std::cerr << fmt::format("{}: {} runs are left out: their faults are defined otherwise now\n",
                             options.records, outdated);
  }
  const auto no_alarm = run_campaign(options, *faults, *records);
  if (!no_alarm) {
    std::cerr << no_alarm.error().message() << '\n';
    return 2;
  }
  if (const auto finished = records->finish(); !finished) {
    std::cerr << finished.error().message() << '\n';
    return 2;
  }
  print_summary(driver_rows(rows_of(*faults, *records)));
  if (!options.tables.empty()) {
    if (const auto written = write_tables(options.tables, *faults, *records); !written) {
      std::cerr << written.error().message() << '\n';
      return 2;
    }
  }
  const std::vector<std::string> left = survivors(*faults, *records);
  for (const std::string& name : left) std::cout << "not noticed: " << name << '\n';
  return left.empty() && *no_alarm ? 0 : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  CLI::App app{
      "Plants faults one at a time and measures how soon each driver notices. Exits 1 on a "
      "false alarm, or if a fault is left that neither properties nor hunt notice."};
  Options options;
  app.add_option(
         "--drivers", options.drivers,
         "random, rapidcheck, libfuzzer-raw, contacts, traces, corpus, by-chance, libfuzzer, "
         "properties, hunt; by default all that this build has: libFuzzer needs clang and "
         "CCDFUZZ_FUZZ")
      ->delimiter(',');
  app.add_option("--faults", options.faults, "Names; by default all")->delimiter(',');
  app.add_option("--seeds", options.seeds, "Runs of each driver against each fault");
  app.add_option("--seconds", options.seconds, "CPU time of a run");
  app.add_option("--weak-seeds", options.weak_seeds,
                 "The same of all but libfuzzer, properties, hunt");
  app.add_option("--weak-seconds", options.weak_seconds, "The same of these");
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
  try {
    return run_all(options);
  } catch (const std::exception& error) {
    std::cerr << "ccdfuzz-scoreboard: " << error.what() << '\n';
    return 3;
  }
}
