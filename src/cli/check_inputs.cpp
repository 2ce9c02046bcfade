#include "cli/check_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/in_order.hpp"

namespace ccdfuzz {

namespace {

/// Inputs between two looks at the clock and the signals, at first and at most: some properties
/// take milliseconds an input, others less than one microsecond.
constexpr std::uint64_t kFirstBatch = 4, kLargestBatch = 1024;

/// So many inputs are all discarded before a property is given up whose time is over.
constexpr std::uint64_t kDiscardedInVain = 1000;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

CheckTally check_inputs(const Property& property, const CheckedInputs& inputs,
                        const std::atomic<bool>& stop, InputWatch& watch, Progress& progress,
                        const std::function<void(const CheckTally&)>& on_failure) {
  CheckTally tally;
  const Clock::time_point start = Clock::now();
  std::uint64_t batch = kFirstBatch;
  const std::uint64_t limit = inputs.seconds ? ~std::uint64_t{0} - inputs.first : inputs.count;
  const auto in_time = [&] {
    return !inputs.seconds || seconds_since(start) < *inputs.seconds ||
           (tally.discarded == tally.checked && tally.checked < kDiscardedInVain);
  };
  while (tally.checked < limit && !stop && in_time()) {
    const std::uint64_t from = inputs.first + tally.checked;
    run_in_order<Check>(
        std::min(batch, limit - tally.checked), inputs.threads,
        [&](size_t i) {
          const InputWatch::At at(watch, from + i);
          RandomChoices choices = inputs.choices(from + i);
          return run(property, choices);
        },
        [&](const Check& result) {
          if (result.status == Check::Status::kDiscarded) ++tally.discarded;
          if (result.status == Check::Status::kFails && tally.failed++ == 0) {
            tally.first_failure = inputs.first + tally.checked;
            tally.text = result.text;
            on_failure(tally);
          }
          ++tally.checked;
        },
        &stop);
    batch = std::min(2 * batch, kLargestBatch);
    tally.seconds = seconds_since(start);
    progress.show(
        inputs.seconds ? std::min(1.0, tally.seconds / *inputs.seconds)
                       : static_cast<double>(tally.checked) / static_cast<double>(limit),
        fmt::format("{}: {} checked, {} failed", property.name, tally.checked, tally.failed),
        tally.checked, "inputs");
  }
  return tally;
}

}  // namespace ccdfuzz
