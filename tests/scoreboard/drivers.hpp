#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ccdfuzz {

/// Ways to look for faults, which the scoreboard compares.
enum class Driver : std::uint8_t {
  kRandom,      ///< random patches, each answer held against what the sound sources prove
  kRapidCheck,  ///< the same, and the envelope claims, on RapidCheck's own arbitrary doubles
  kProperties,  ///< every property that holds, on choices of its own draw
  kHunt,        ///< generated witnesses, traced and asked
};
inline constexpr std::array kDrivers = {Driver::kRandom, Driver::kRapidCheck, Driver::kProperties,
                                        Driver::kHunt};
std::string_view name_of(Driver driver);

/// Runs a driver until it finds something wrong or the process has used so much CPU time.
struct DriverRun {
  std::uint64_t executions = 0;
  std::string found;  ///< what is wrong; empty if nothing was found
};
DriverRun drive(Driver driver, std::uint64_t seed, double cpu_seconds);

/// CPU time of the process.
double cpu_seconds_used();

}  // namespace ccdfuzz
