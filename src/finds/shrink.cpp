#include "finds/shrink.hpp"

#include <algorithm>

namespace ccdfuzz {

namespace {

constexpr std::uint64_t kTrialsOfAHang = 6;

}  // namespace

Minimised shrink(const Case& found, const Failure& failure, Asker& asker, MinimiseOptions options) {
  if (failure.cause == "hang") options.max_trials = std::min(options.max_trials, kTrialsOfAHang);
  Case start = found;
  start.asked = asked_with(asker.search());
  start.expect.clear();
  Minimised minimised = minimise(
      start, failure.outcome,
      [&](const Case& simpler) { return asker.failure(failure.who, simpler) == failure; }, options);
  minimised.value.origin.name.clear();
  minimised.value.expect[failure.who] = {failure.outcome, failure.cause};
  return minimised;
}

}  // namespace ccdfuzz
