#include "verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ccdfuzz {

namespace {

std::string indented(const std::string& command) {
  return "\n  again: ccdfuzz-scoreboard " + command;
}

/// Twice the time: the machine may be slower then, and properties come in turn by the time that
/// they take.
std::string repetition(const Record& r) {
  return indented(
      fmt::format("--drivers {} --faults {} --only-seed {} --seconds {} --weak-seconds {}",
                  name_of(r.driver), r.fault, r.seed, 2 * r.limit, 2 * r.limit));
}

bool is_survivor(const PlantedFault& fault, const Records& records) {
  bool asked = false;
  for (const auto& [key, record] : records.all()) {
    if (record.fault != fault.name) continue;
    if (is_weak(record.driver)) continue;
    if (record.detected) return false;
    asked = true;
  }
  return asked && fault.equivalent.empty();
}

}  // namespace

std::string alarm(const Record& r, const std::vector<PlantedFault>& faults) {
  if (!r.detected) return "";
  if (r.fault == kNoFault || r.fault == kWatchedFaults) {
    return fmt::format("false alarm: {} seed {}{}: {}{}", name_of(r.driver), r.seed,
                       r.fault == kNoFault ? "" : ", all faults watched", r.found, repetition(r));
  }
  const auto fault = std::ranges::find(faults, r.fault, &PlantedFault::name);
  if (fault == faults.end() || fault->equivalent.empty()) return "";
  return fmt::format("equivalent, but noticed: {} by {} seed {}: {}{}", r.fault, name_of(r.driver),
                     r.seed, r.found, repetition(r));
}

std::vector<std::string> complaints(const std::vector<PlantedFault>& faults,
                                    const Records& records) {
  std::vector<std::string> all;
  for (const auto& [key, record] : records.all()) {
    if (std::string text = alarm(record, faults); !text.empty()) all.push_back(std::move(text));
  }
  for (const PlantedFault& fault : faults) {
    if (!is_survivor(fault, records)) continue;
    all.push_back(fmt::format("not noticed: {}{}", fault.name,
                              indented("--drivers properties,hunt --faults " + fault.name)));
  }
  return all;
}

}  // namespace ccdfuzz
