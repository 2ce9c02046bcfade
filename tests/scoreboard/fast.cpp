// The part of the scoreboard that every build affords: the properties of Steps II and III, which
// are headers, against faults of these. Exits 1 if one is not noticed in its time, or if the right
// sources are said to fail. `scoreboard_fast FAULTS all` tries every fault of these files.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "fault_list.hpp"
#include "properties/envelope.hpp"
#include "properties/intersection.hpp"
#include "properties/omission.hpp"
#include "properties/predicates.hpp"
#include "property_turns.hpp"
#include "run_apart.hpp"

namespace ccdfuzz {
namespace {

constexpr std::array kFastFaults = {
    "product.sign",      "product.bound.one_side", "end.bound.no_intercept",     "bound.zero",
    "bound.negative",    "negative.wrong_sign",    "redundant.always",           "constr.negative",
    "raise.down",        "root.left.outward",      "root.right.outward",         "root.sign",
    "envelope.Phi.p",    "envelope.Phi.q",         "envelope.6_at_start",        "cross.8a_index",
    "cross.back_turned", "separation.7_at_end",    "separation.7_back_at_start", "line.height"};

std::vector<Property> properties_of_lines() {
  std::vector<Property> list = {
      {"tdibm-e.envelope", "", "", Expectation::kHolds, check_envelope<ErrorBoundIntended>},
      {"tdibm-e.separation", "", "", Expectation::kHolds, check_separation<ErrorBoundIntended>},
      {"tdibm.ends", "", "", Expectation::kHolds, check_ends<Plain>}};
  for (const auto& family : {intersection_properties, omission_properties, predicate_properties}) {
    for (const Property& p : family()) list.push_back(p);
  }
  return list;
}

int run_fast(const std::string& path, bool all) {
  constexpr double kSeconds = 10, kCleanSeconds = 1;
  constexpr int kMostAbsent = 2;  // whose text has changed, so that they were not planted
  const auto faults = read_faults(path);
  if (!faults) {
    std::cerr << faults.error().message() << '\n';
    return 2;
  }
  int wrong = 0, killed = 0, absent = 0;
  for (std::size_t f = 0; f <= faults->size(); ++f) {
    const std::string name = f == 0 ? "none" : (*faults)[f - 1].name;
    if (f > 0 && !all && std::ranges::find(kFastFaults, name) == kFastFaults.end()) continue;
    const double limit = f == 0 ? kCleanSeconds : kSeconds;
    const Report report = run_apart(static_cast<int>(f), limit, [&](const auto& done) {
      PropertyTurns turns(properties_of_lines(), 1);
      DriverRun run;
      for (; run.found.empty() && cpu_seconds_used() < limit; ++run.executions) {
        run.found = turns();
      }
      done(run);
    });
    if (f > 0 && report.reached == 0 && !report.detected) {
      ++absent;
      continue;
    }
    const bool right = report.detected == (f > 0);
    killed += report.detected ? 1 : 0;
    if (!right) ++wrong;
    std::cout << fmt::format("{:30} {} {:.3f} s {:.100}\n", name, right ? "ok   " : "WRONG",
                             report.seconds, std::string_view(report.found));
  }
  std::cout << fmt::format("{} noticed, {} wrong, {} not there\n", killed, wrong, absent);
  return wrong == 0 && (all || absent <= kMostAbsent) ? 0 : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  try {
    return ccdfuzz::run_fast(argv[1], argc > 2);
  } catch (const std::exception& error) {
    std::cerr << "scoreboard_fast: " << error.what() << '\n';
    return 3;
  }
}
