#pragma once

#include <string>
#include <vector>

#include "properties/property.hpp"

namespace ccdfuzz {

/// CPU time of the process.
double cpu_seconds_used();

/// Those of the properties that hold, on choices of their own draw; the one next that has taken the
/// least time. Each call checks one; what fails, after the command that checks it on the same
/// choices, or nothing.
class PropertyTurns {
 public:
  PropertyTurns(const std::vector<Property>& properties, std::uint64_t seed);
  std::string operator()();

 private:
  struct Turn {
    Property property;
    double seconds = 0;
    std::uint64_t index = 0;
  };

  std::vector<Turn> turns_;
  std::uint64_t seed_;
};

}  // namespace ccdfuzz
