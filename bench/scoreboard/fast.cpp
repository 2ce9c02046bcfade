// The part of the scoreboard that every build affords: the properties of Steps II and III, which
// are headers, against faults of these. Exits 1 if one is not noticed in its time, or if the right
// sources are said to fail.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>

#include "fault_list.hpp"
#include "planted.hpp"
#include "properties/property.hpp"
#include "property_turns.hpp"
#include "run_apart.hpp"

namespace ccdfuzz {

std::vector<Property> envelope_claims();
std::vector<Property> intersection_claims();
std::vector<Property> omission_claims();
std::vector<Property> predicates_claims();
std::vector<Property> separation_claims();

namespace {

constexpr std::array kFastFaults = {
    "product.sign",      "product.bound.one_side", "end.bound.no_intercept",     "bound.zero",
    "bound.negative",    "negative.wrong_sign",    "redundant.always",           "constr.negative",
    "raise.down",        "root.left.outward",      "root.right.outward",         "root.sign",
    "envelope.Phi.p",    "envelope.Phi.q",         "envelope.6_at_start",        "cross.8a_index",
    "cross.back_turned", "separation.7_at_end",    "separation.7_back_at_start", "line.height"};

constexpr const char* kNone = "none";  // the right sources

constexpr const char* kUsage =
    R"(usage: scoreboard_fast FAULTS LEFT_OUT [none | FAULT]
FAULTS: the list. LEFT_OUT: the file of names of those that plant could not plant.
By default twenty faults and the right sources; none: these alone; FAULT: this one.
)";

std::vector<Property> properties_of_lines() {
  std::vector<Property> list;
  for (const auto& family : {envelope_claims, intersection_claims, omission_claims,
                             predicates_claims, separation_claims}) {
    for (const Property& p : family()) list.push_back(p);
  }
  return list;
}

Report report_of(int fault) {
  const double limit = fault == planted::kNone ? 1 : 10;
  return run_apart(fault, limit, [&](const auto& done) {
    PropertyTurns turns(properties_of_lines(), 1);
    DriverRun run;
    Heartbeat heart;
    for (; run.found.empty() && cpu_seconds_used() < limit; ++run.executions) {
      heart.beat();
      run.found = turns();
    }
    done(run);
  });
}

Result<std::set<std::string>> names_in(const std::string& path) {
  std::ifstream in(path);
  if (!in) return input_error(path, "cannot be read");
  std::set<std::string> names;
  for (std::string line; std::getline(in, line);) names.insert(line);
  return names;
}

/// The numbers of the faults that are asked for, 0 being none. Errors: a name that is not in the
/// list.
Result<std::vector<int>> numbers_of(const std::vector<PlantedFault>& faults,
                                    const std::string& asked) {
  std::vector<std::string> names{kNone};
  names.insert(names.end(), kFastFaults.begin(), kFastFaults.end());
  if (!asked.empty()) names = {asked};
  std::vector<int> numbers;
  for (const std::string& name : names) {
    const auto fault = std::ranges::find(faults, name, &PlantedFault::name);
    if (name == kNone) {
      numbers.push_back(planted::kNone);
    } else if (fault != faults.end()) {
      numbers.push_back(static_cast<int>(fault - faults.begin()) + 1);
    } else {
      return input_error("", "no fault \"{}\"", name);
    }
  }
  return numbers;
}

int run_fast(const std::string& path, const std::string& left_out_path, const std::string& asked) {
  constexpr int kMostAbsent = 2;  // whose text has changed, so that they were not planted
  const auto fail = [](const InputError& error) {
    std::cerr << "scoreboard_fast: " << error.message() << '\n';
    return 2;
  };
  const auto faults = read_faults(path);
  if (!faults) return fail(faults.error());
  const auto left_out = names_in(left_out_path);
  if (!left_out) return fail(left_out.error());
  const auto numbers = numbers_of(*faults, asked);
  if (!numbers) return fail({path, numbers.error().what});
  int wrong = 0, killed = 0, absent = 0;
  for (const int number : *numbers) {
    const std::string name = number == planted::kNone ? kNone : (*faults)[number - 1].name;
    if (left_out->contains(name)) {
      ++absent;
      std::cout << fmt::format("{:30} not planted\n", name);
      continue;
    }
    const Report report = report_of(number);
    const bool right = report.detected == (number != planted::kNone);
    killed += report.detected ? 1 : 0;
    std::cout << fmt::format("{:30} {} {:.3f} s {}\n", name, right ? "ok   " : "WRONG",
                             report.seconds, report.found);
    if (right) continue;
    ++wrong;
    std::cout << fmt::format("  again: scoreboard_fast {} {} {}\n", path, left_out_path, name);
  }
  std::cout << fmt::format("{} noticed, {} wrong, {} not planted\n", killed, wrong, absent);
  return wrong == 0 && absent <= (asked.empty() ? kMostAbsent : 0) ? 0 : 1;
}

}  // namespace
}  // namespace ccdfuzz

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    std::cerr << ccdfuzz::kUsage;
    return 2;
  }
  try {
    return ccdfuzz::run_fast(argv[1], argv[2], argc > 3 ? argv[3] : "");
  } catch (const std::exception& error) {
    std::cerr << "scoreboard_fast: " << error.what() << '\n';
    return 3;
  }
}
