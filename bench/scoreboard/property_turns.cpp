#include "property_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

namespace ccdfuzz {

double cpu_seconds_used() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

PropertyTurns::PropertyTurns(const std::vector<Property>& properties, std::uint64_t seed)
    : seed_(seed) {
  for (const Property& p : properties) {
    if (p.expected == Expectation::kHolds) turns_.push_back({p});
  }
}

std::string PropertyTurns::operator()() {
  Turn& turn = *std::ranges::min_element(turns_, {}, &Turn::seconds);
  const double start = cpu_seconds_used();
  const std::uint64_t index = turn.index++;
  Draw choices = Draw::mostly_small(Random::keyed({seed_, index}));
  const Check check = run(turn.property, choices);
  turn.seconds += cpu_seconds_used() - start;
  const bool fails = check.status == Check::Status::kFails;
  return fails ? fmt::format("ccdfuzz check {} --seed {} --first {} --count 1: {}",
                             turn.property.name, seed_, index, check.text)
               : "";
}

}  // namespace ccdfuzz
