#include "cli/check_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/stopwatch.hpp"
#include "io/in_order.hpp"

namespace ccdfuzz {

namespace {

/// Inputs of a question, at most: some properties take milliseconds an input, others less than one
/// microsecond. Twice as many as before while a round takes less than kShortRound seconds.
constexpr std::uint64_t kLargestRange = 1024;
constexpr double kShortRound = 0.1;
/// Questions between two looks at the clock, for each thread.
constexpr std::uint64_t kRangesEach = 4;

/// A property whose time is over, or one of a method, is given up after this many inputs, if all
/// were discarded.
constexpr std::uint64_t kDiscardedInVain = 1000;

}  // namespace

CheckTally check_inputs(const Property& property, const CheckedInputs& inputs,
                        ClaimChildren& children, const std::atomic<bool>& stop, Progress& progress,
                        const std::function<void(const CheckTally&)>& on_failure) {
  CheckTally tally;
  const Stopwatch watch;
  std::uint64_t limit = inputs.seconds ? ~std::uint64_t{0} - inputs.first : inputs.count;
  const auto is_vain = [&] {
    return tally.discarded == tally.checked && tally.checked < kDiscardedInVain;
  };
  const auto in_time = [&] {
    return !inputs.seconds || tally.seconds < *inputs.seconds || is_vain();
  };
  const auto has_more = [&] {
    const bool is_of_method = !property.method.empty();
    if (tally.checked == limit && is_of_method && is_vain()) {
      limit = std::min(2 * limit, kDiscardedInVain);
    }
    return tally.checked < limit && in_time();
  };
  const auto ranges = static_cast<std::uint64_t>(inputs.threads) * kRangesEach;
  for (std::uint64_t range = 1; has_more() && !tally.is_cut_short && !stop;) {
    const double before = tally.seconds;
    const std::uint64_t from = tally.checked;
    const std::uint64_t here = std::min(ranges * range, limit - from);
    run_in_order<CheckTally>((here + range - 1) / range, inputs.threads,
                             [&](size_t i) {
                               const std::uint64_t done = i * range;
                               return children.local().on_draws(property, inputs.seed,
                                                                inputs.first + from + done,
                                                                std::min(range, here - done));
                             },
                             [&](const CheckTally& next) {
                               if (tally.is_cut_short) return;
                               const bool is_first = tally.failed == 0 && next.failed > 0;
                               tally.add(next);
                               if (is_first) on_failure(tally);
                             },
                             &stop);
    tally.seconds = watch.seconds();
    if (tally.seconds - before < kShortRound) range = std::min(2 * range, kLargestRange);
    progress.show(
        inputs.seconds ? std::min(1.0, tally.seconds / *inputs.seconds)
                       : static_cast<double>(tally.checked) / static_cast<double>(limit),
        fmt::format("{}: {} checked, {} failed", property.name, tally.checked, tally.failed),
        tally.checked, "inputs");
  }
  return tally;
}

}  // namespace ccdfuzz
