// Faults against drivers: which driver notices which fault, and how soon. Each run is a process of
// its own, so that a fault that crashes or hangs is noticed too, and no run depends on another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "base/number_text.hpp"
#include "campaign.hpp"
#include "fault_list.hpp"
#include "records.hpp"
#include "rows.hpp"
#include "verdict.hpp"

namespace ccdfuzz {
namespace {

struct Options : CampaignOptions {
  std::string records, tables;
  bool no_runs = false;
};

int fail(const InputError& error) {
  std::cerr << error.message() << '\n';
  return 2;
}

int run_all(const Options& options) {
  const auto faults = read_faults(CCDFUZZ_FAULTS);
  if (!faults) return fail(faults.error());
  if (const auto checked = check_options(options, *faults); !checked) return fail(checked.error());
  if (!options.tables.empty()) {
    if (const auto probed = probe_tables(options.tables); !probed) return fail(probed.error());
  }
  auto records = Records::open(options.records, *faults,
                               options.no_runs ? Records::Use::kRead : Records::Use::kExtend);
  if (!records) return fail(records.error());
  if (const std::size_t outdated = records->outdated(); outdated > 0) {
    std::cerr << fmt::format("{}: {} runs are left out: their faults are defined otherwise now\n",
                             options.records, outdated);
  }
  if (!options.no_runs) {
    if (const auto run = run_campaign(options, *faults, *records); !run) return fail(run.error());
  }
  if (records->all().empty()) return fail({options.records, "has no record"});
  // The watched run, and the file of records, tell of more.
  const std::vector<PlantedFault> asked = asked_faults(options, *faults);
  std::cout << driver_table(driver_rows(rows_of(asked, *records))).to_text(false);
  if (!options.tables.empty()) {
    if (const auto written = write_tables(options.tables, asked, *records); !written) {
      return fail(written.error());
    }
  }
  const std::vector<std::string> wrong = complaints(asked, *records);
  for (const std::string& text : wrong) std::cout << text << '\n';
  if (!std::cout.flush()) return fail({"stdout", "cannot be written"});
  return wrong.empty() ? 0 : 1;
}

/// What is wrong with a count of seeds, as CLI11 wants it.
std::string check_whole(const std::string& text) {
  constexpr std::uint64_t kMost = 1'000'000;
  const Result<std::uint64_t> number = parse_whole("", text, 1, kMost);
  return number ? "" : number.error().what;
}

/// The same of a time limit.
std::string check_seconds(const std::string& text) {
  constexpr double kMost = 1e6;
  const Result<double> seconds = parse_seconds("", text);
  if (!seconds) return seconds.error().what;
  return *seconds <= kMost ? "" : fmt::format("{} is more than {} s", text, kMost);
}

void add_options(CLI::App& app, Options& options) {
  std::vector<CLI::Option*> of_runs;
  const auto add_names = [&](const char* name, auto& values, const char* description) {
    of_runs.push_back(app.add_option(name, values, description)->delimiter(','));
  };
  const auto add_whole = [&](const char* name, auto& value, const char* description) {
    of_runs.push_back(app.add_option(name, value, description)->check(check_whole)->type_name("N"));
    return of_runs.back();
  };
  const auto add_seconds = [&](const char* name, double& value, const char* description) {
    const auto set = [&value](const std::string& text) { value = *parse_seconds("", text); };
    of_runs.push_back(app.add_option_function<std::string>(name, set, description)
                          ->check(check_seconds)
                          ->type_name("S")
                          ->default_str(fmt::format("{}", value)));
  };
  add_names("--drivers", options.drivers,
            "random, rapidcheck, contacts, traces, corpus, by-chance, properties, hunt; by default "
            "all");
  add_names("--faults", options.faults,
            "Names; by default all. What is printed and written to --tables is of these alone. "
            "Each driver runs on the right sources first; \"none\": on these "
            "alone, \"watched\": then with all faults watched");
  add_whole("--seeds", options.seeds, "Runs of each driver against each fault, seeds 1 to N")
      ->capture_default_str();
  add_seconds("--seconds", options.seconds, "CPU time of a run");
  add_whole("--weak-seeds", options.weak_seeds, "The same of all but properties, hunt")
      ->capture_default_str();
  add_seconds("--weak-seconds", options.weak_seconds, "The same of these");
  add_whole("--only-seed", options.only_seed, "Runs with this seed alone")
      ->excludes(app.get_option("--seeds"))
      ->excludes(app.get_option("--weak-seeds"));
  of_runs.push_back(app.add_flag("--verbose", options.verbose, "A line a run"));
  app.add_option("--tables", options.tables,
                 "Writes what the records say to PREFIX.md and PREFIX.json")
      ->type_name("PREFIX");
  CLI::Option* const records =
      app.add_option("--records", options.records,
                     "What is known already. New records are appended: a campaign that stopped "
                     "goes on from there")
          ->type_name("FILE");
  CLI::Option* const no_runs =
      app.add_flag("--no-runs", options.no_runs,
                   "Runs nothing: prints, and writes to --tables, what the records say");
  no_runs->needs(records);
  for (CLI::Option* option : of_runs) no_runs->excludes(option);
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  using namespace ccdfuzz;
  CLI::App app{
      "Plants faults one at a time and measures how soon each driver notices. Exits 1 on a "
      "false alarm, if a fault is noticed that is said to change nothing, or if one is left that "
      "neither properties nor hunt notice."};
  Options options;
  add_options(app, options);
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
