// Faults against drivers: which driver notices which fault, and how soon. Each run is a process of
// its own, so that a fault that crashes or hangs is noticed too, and no run depends on another.
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>

#include "drivers.hpp"
#include "eval/table.hpp"
#include "fault_list.hpp"
#include "records.hpp"
#include "scoreboard/planted.hpp"

namespace ccdfuzz {
namespace {

constexpr const char* kNoFault = "none";

struct Options {
  std::vector<std::string> drivers, faults;
  std::uint64_t seeds = 5;
  double seconds = 60;
  int every = 1;
  std::string records;
  bool fast = false, verbose = false;
};

struct Run {
  Driver driver;
  int fault = 0;  ///< its number; 0: none
  std::uint64_t seed = 0;
};

/// What the child writes before it ends.
struct Report {
  std::uint64_t reached = 0, triggered = 0, executions = 0;
  double seconds = 0;
  bool detected = false;
  char found[200] = "";
};

Report run_here(const Run& run, double seconds) {
  planted::active_fault = run.fault;
  const double start = cpu_seconds_used();
  const DriverRun result = drive(run.driver, run.seed, seconds);
  Report report{planted::reached,           planted::triggered,    result.executions,
                cpu_seconds_used() - start, !result.found.empty(), ""};
  const std::string line = result.found.substr(0, result.found.find('\n'));
  line.copy(report.found, sizeof report.found - 1);
  return report;
}

/// In a process of its own. One that dies, or hangs past its time, counts as noticed.
Report run_apart(const Run& run, double seconds) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const auto limit = static_cast<rlim_t>(seconds) + 5;
    const rlimit cpu{limit, limit};
    setrlimit(RLIMIT_CPU, &cpu);
    const rlimit memory{rlim_t{2} << 30, rlim_t{2} << 30};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const Report report = run_here(run, seconds);
    [[maybe_unused]] const auto written = write(ends[1], &report, sizeof report);
    _exit(0);
  }
  close(ends[1]);
  Report report;
  const bool whole = read(ends[0], &report, sizeof report) == static_cast<ssize_t>(sizeof report);
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (whole) return report;
  Report died;
  died.detected = true;
  died.seconds = static_cast<double>(usage.ru_utime.tv_sec) +
                 static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
  const std::string what = fmt::format("the process ends by signal {}", WTERMSIG(status));
  what.copy(died.found, sizeof died.found - 1);
  return died;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string seconds_text(double seconds) {
  return seconds < 0.0995 ? fmt::format("{:.1f} ms", seconds * 1e3)
                          : fmt::format("{:.2f} s", seconds);
}

/// A row a driver: how many faults it noticed, and how soon; misses count as the limit.
void print_summary(const Options& options, const std::vector<Fault>& faults,
                   const Records& records) {
  Table table({{"driver", Align::kLeft},
               {"faults"},
               {"reached"},
               {"triggered"},
               {"detected"},
               {"median time"},
               {"median executions"},
               {"mean time"},
               {"false alarms"}});
  for (const Driver driver : kDrivers) {
    const std::string name(name_of(driver));
    std::size_t met = 0, reached = 0, triggered = 0, detected = 0, alarms = 0, clean = 0;
    std::vector<double> times, executions;
    double sum = 0;
    for (std::size_t f = 0; f <= faults.size(); ++f) {
      std::vector<double> of_fault, executions_of_fault;
      bool was_reached = false, was_triggered = false;
      std::size_t kills = 0;
      for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) {
        const auto found = records.all().find({name, f == 0 ? kNoFault : faults[f - 1].name, seed});
        if (found == records.all().end()) continue;
        const Record& r = found->second;
        if (f == 0) {
          ++clean, alarms += r.detected ? 1 : 0;
          continue;
        }
        was_reached = was_reached || r.reached > 0 || r.detected;
        was_triggered = was_triggered || r.triggered > 0 || r.detected;
        kills += r.detected ? 1 : 0;
        of_fault.push_back(r.detected ? r.seconds : r.limit);
        executions_of_fault.push_back(static_cast<double>(r.executions));
      }
      if (of_fault.empty() || !faults[f - 1].equivalent.empty()) continue;
      ++met;
      reached += was_reached ? 1 : 0;
      triggered += was_triggered ? 1 : 0;
      detected += 2 * kills > of_fault.size() ? 1 : 0;
      times.push_back(median(of_fault));
      executions.push_back(median(executions_of_fault));
      sum += times.back();
    }
    if (met == 0) continue;
    table.add_row({{name},
                   {fmt::format("{}", met)},
                   {fmt::format("{}", reached)},
                   {fmt::format("{}", triggered)},
                   {fmt::format("{}", detected)},
                   {seconds_text(median(times))},
                   {fmt::format("{:.0f}", median(executions))},
                   {seconds_text(sum / static_cast<double>(met))},
                   {fmt::format("{} of {}", alarms, clean)}});
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

int run_all(Options options) {
  const auto faults = read_faults(CCDFUZZ_FAULTS);
  if (!faults) {
    std::cerr << faults.error().message() << '\n';
    return 2;
  }
  if (options.fast) {
    options.drivers = {"properties"};
    options.seeds = 1;
    options.seconds = 4;
    options.every = 4;
  }
  auto records = Records::open(options.records);
  if (!records) {
    std::cerr << records.error().message() << '\n';
    return 2;
  }
  bool alarm = false;
  for (const Driver driver : kDrivers) {
    const std::string driver_name(name_of(driver));
    if (!wanted(options.drivers, driver_name)) continue;
    for (std::size_t f = 0; f <= faults->size(); ++f) {
      const std::string fault = f == 0 ? kNoFault : (*faults)[f - 1].name;
      if (f > 0 && (!wanted(options.faults, fault) ||
                    (f - 1) % static_cast<std::size_t>(options.every) != 0))
        continue;
      for (std::uint64_t seed = 1; seed <= options.seeds; ++seed) {
        if (records->find(driver_name, fault, seed, options.seconds) != nullptr) continue;
        const Report report = run_apart({driver, static_cast<int>(f), seed}, options.seconds);
        const Record record{driver_name,       fault,           seed,
                            options.seconds,   report.reached,  report.triggered,
                            report.executions, report.detected, report.seconds,
                            report.found};
        if (const auto added = records->add(record); !added) {
          std::cerr << added.error().message() << '\n';
          return 2;
        }
        if (f == 0 && report.detected) {
          alarm = true;
          std::cout << "false alarm: " << driver_name << " seed " << seed << ": " << report.found
                    << '\n';
        }
        if (options.verbose) {
          std::cout << fmt::format("{:10} {:36} {} {:>9} {:>8} {}\n", driver_name, fault, seed,
                                   report.detected ? seconds_text(report.seconds) : "missed",
                                   report.executions, report.found)
                    << std::flush;
        }
      }
    }
  }
  print_summary(options, *faults, *records);
  const std::vector<std::string> left = survivors(*faults, *records);
  for (const std::string& name : left) std::cout << "not noticed: " << name << '\n';
  return alarm || !left.empty() ? 1 : 0;
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
                 "random, rapidcheck, properties, hunt; by default all")
      ->delimiter(',');
  app.add_option("--faults", options.faults, "Names; by default all")->delimiter(',');
  app.add_option("--seeds", options.seeds, "Runs of each driver against each fault");
  app.add_option("--seconds", options.seconds, "CPU time of a run");
  app.add_option("--every", options.every, "Only one fault in so many")->check(CLI::PositiveNumber);
  app.add_option("--records", options.records,
                 "File of what is known already; a campaign that stopped goes on from it");
  app.add_flag("--fast", options.fast, "What CI runs: properties, one fault in four, 4 s each");
  app.add_flag("--verbose", options.verbose, "A line a run");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return run_all(options);
}
