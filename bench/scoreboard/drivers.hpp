#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"
#include "run_apart.hpp"

namespace ccdfuzz {

/// Ways to look for faults, which the scoreboard compares.
enum class Driver : std::uint8_t {
  kRandom,      ///< random patches, each answer held against what the sound sources prove
  kRapidCheck,  ///< the same, and the envelope claims, on RapidCheck's own arbitrary doubles
  kContacts,    ///< contacts of the inverse construction, asked
  kTraces,      ///< the same, their witnesses traced instead
  kCorpus,      ///< the stored counterexamples, traced and asked, each once
  kChance,      ///< kHunt, with mutants bred by chance
  kProperties,  ///< every property that holds, on choices of its own draw
  kHunt,        ///< generated witnesses, traced and asked, and mutants bred towards being lost
};
constexpr std::array<std::string_view, 8> names_of(Driver) {
  return {"random", "rapidcheck", "contacts",   "traces",
          "corpus", "by-chance",  "properties", "hunt"};
}
inline constexpr auto kDrivers = all_of(Driver{});

/// Those that know nothing of the problem, and parts of the hunt: they get less time.
constexpr bool is_weak(Driver driver) {
  return driver != Driver::kProperties && driver != Driver::kHunt;
}

/// Whether what it does depends on a seed.
constexpr bool is_drawn(Driver driver) {
  return driver != Driver::kCorpus;
}

/// When a run that finds nothing ends: at the first of the two.
struct DriveLimit {
  double cpu_seconds = 0;
  std::uint64_t executions = std::numeric_limits<std::uint64_t>::max();
};

/// Runs a driver until it finds something wrong or reaches its limit, and calls done, which must
/// not return.
[[noreturn]] void drive(Driver driver, std::uint64_t seed, const DriveLimit& limit,
                        const std::function<void(const DriverRun&)>& done);

}  // namespace ccdfuzz
