#include "campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <regex>
#include <stdexcept>

#include "drivers.hpp"
#include "io/table.hpp"
#include "verdict.hpp"
#include "watch_apart.hpp"

namespace ccdfuzz {

namespace {

/// Files by their names, whatever folder this was built in.
std::string without_folders(const std::string& text) {
  static const std::regex kFolders(R"(/[^ :]*/([^ /:]+:))");
  return std::regex_replace(text, kFolders, "$1");
}

/// Properties come in turn by the time that they take: no run repeats another.
bool takes_the_same_course(Driver driver) {
  return driver != Driver::kProperties;
}

/// One driver with one seed against all faults.
class Course {
 public:
  Course(Driver driver, std::uint64_t seed, const CampaignOptions& options,
         const std::vector<PlantedFault>& faults, Records& records)
      : driver_(driver),
        seed_(seed),
        limit_(is_weak(driver) ? options.weak_seconds : options.seconds),
        options_(options),
        faults_(faults),
        records_(records) {}

  Result<void> run() {
    CCDFUZZ_TRY_VOID(run_one(planted::kNone, limit_));
    const Record clean = *known(kNoFault, limit_);
    if (clean.detected) return {};
    if (is_watch_missing()) {
      CCDFUZZ_TRY_VOID(watch(clean.executions));
    }
    const Record* const watched = known(kWatchedFaults, limit_);
    if (watched != nullptr && watched->detected) return {};
    for (std::size_t f = 0; f < faults_.size(); ++f) {
      if (!missing()(faults_[f])) continue;
      CCDFUZZ_TRY_VOID(run_one(static_cast<int>(f + 1), limit_of(faults_[f])));
    }
    return {};
  }

 private:
  double limit_of(const PlantedFault& fault) const {
    return fault.equivalent.empty() ? limit_ : std::min(limit_, options_.weak_seconds);
  }
  const Record* known(const std::string& fault, double limit) const {
    return records_.find(driver_, fault, seed_, limit);
  }
  bool is_watch_missing() const {
    if (!takes_the_same_course(driver_) || known(kWatchedFaults, limit_) != nullptr) return false;
    return std::ranges::find(options_.faults, kWatchedFaults) != options_.faults.end() ||
           std::ranges::any_of(faults_, missing());
  }
  std::function<bool(const PlantedFault&)> missing() const {
    return [this](const PlantedFault& fault) {
      if (!is_wanted(options_.faults, fault.name)) return false;
      if (!fault.equivalent.empty() && seed_ > 1 && !options_.only_seed) return false;
      return known(fault.name, limit_of(fault)) == nullptr;
    };
  }

  /// What a run gives; what prevents it is said to be of that run.
  template <class Run>
  auto of_the_run(const std::string& fault, const Run& run) const {
    try {
      return run();
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}, fault {}, seed {}: {}", name_of(driver_), fault, seed_, error.what()));
    }
  }

  Result<void> run_one(int f, double limit) {
    const std::string fault = f == planted::kNone ? kNoFault : faults_[f - 1].name;
    if (known(fault, limit) != nullptr) return {};
    const Report report = of_the_run(fault, [&] {
      return run_apart(f, limit, [&](const auto& done) { drive(driver_, seed_, {limit}, done); });
    });
    return add(fault, limit, report);
  }

  /// As many executions as the clean run had, which take longer where all faults are watched.
  Result<void> watch(std::uint64_t executions) {
    constexpr double kLonger = 6;
    const WatchReport seen = of_the_run(kWatchedFaults, [&] {
      return watch_apart(kLonger * limit_, [&](const auto& done) {
        drive(driver_, seed_, {kLonger * limit_, executions}, done);
      });
    });
    const bool whole = !seen.report.detected && seen.report.executions >= executions;
    for (std::size_t f = 0; whole && f < faults_.size(); ++f) {
      const int number = static_cast<int>(f + 1);
      if (seen.faults.triggered[number] || known(faults_[f].name, limit_) != nullptr) continue;
      Report decided = seen.report;
      decided.reached = seen.faults.reached[number] ? 1 : 0;
      decided.triggered = 0;
      decided.seconds = limit_;
      CCDFUZZ_TRY_VOID(add(faults_[f].name, limit_, decided, true));
    }
    return add(kWatchedFaults, limit_, seen.report);
  }

  Result<void> add(const std::string& fault, double limit, const Report& report,
                   bool watched = false) {
    const Record record{driver_,
                        fault,
                        seed_,
                        limit,
                        report.reached,
                        report.triggered,
                        report.executions,
                        report.detected,
                        watched,
                        report.seconds,
                        without_folders(report.found),
                        ""};
    // The watched run decides more faults than were asked for.
    if (options_.verbose && (!watched || is_asked(options_, fault))) {
      std::cout << fmt::format("{:13} {:36} {} {:>9} {:>8} {}\n", name_of(driver_), fault, seed_,
                               watched ? "not triggered"
                               : record.detected
                                   ? duration_text(record.seconds)
                                   : fmt::format("- ({})", duration_text(record.seconds)),
                               record.executions, record.found)
                << std::flush;
    }
    if (const std::string text = alarm(record, faults_); !text.empty()) {
      std::cerr << text << std::endl;
    }
    return records_.add(record);
  }

  Driver driver_;
  std::uint64_t seed_;
  double limit_;
  const CampaignOptions& options_;
  const std::vector<PlantedFault>& faults_;
  Records& records_;
};

}  // namespace

Result<void> run_campaign(const CampaignOptions& options, const std::vector<PlantedFault>& faults,
                          Records& records) {
  const std::uint64_t first = options.only_seed.value_or(1);
  const std::uint64_t last =
      options.only_seed.value_or(std::max(options.seeds, options.weak_seeds));
  // Seed by seed: a campaign that is stopped has something of every fault.
  for (std::uint64_t seed = first; seed <= last; ++seed) {
    for (const Driver driver : kDrivers) {
      if (!is_wanted(options.drivers, name_of(driver))) continue;
      const std::uint64_t seeds = is_weak(driver) ? options.weak_seeds : options.seeds;
      if (!options.only_seed && seed > seeds) continue;
      if (!is_drawn(driver) && seed > first) continue;
      const std::uint64_t its_seed = is_drawn(driver) ? seed : 1;
      CCDFUZZ_TRY_VOID(Course(driver, its_seed, options, faults, records).run());
    }
  }
  return {};
}

}  // namespace ccdfuzz
