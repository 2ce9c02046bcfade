#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "cli/input_watch.hpp"
#include "cli/terminal.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// Which inputs of a property to check: first, first + 1, … of the seed.
struct CheckedInputs {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t count = 1000;
  /// Instead of count: for so long, and until one input was not discarded or 1000 were.
  std::optional<double> seconds;
  int threads = 1;

  RandomChoices choices(std::uint64_t index) const {
    return RandomChoices{Random::keyed({seed, index})};
  }
};

/// What the inputs showed of one property.
struct CheckTally {
  std::uint64_t checked = 0, discarded = 0, failed = 0;
  std::uint64_t first_failure = 0;  ///< index of the input
  std::string text;                 ///< of the first failure
  double seconds = 0;

  bool all_discarded() const { return checked > 0 && discarded == checked; }
};

/// Depends on the inputs alone, but for the time that it took. stop: no further inputs. on_failure
/// is called once, as soon as the first failure is known, from any thread.
CheckTally check_inputs(const Property& property, const CheckedInputs& inputs,
                        const std::atomic<bool>& stop, InputWatch& watch, Progress& progress,
                        const std::function<void(const CheckTally&)>& on_failure);

}  // namespace ccdfuzz
