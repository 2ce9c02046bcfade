#include "finds/shrink.hpp"

#include <algorithm>

#include "certify/checker/check_case.hpp"

namespace ccdfuzz {

namespace {

constexpr std::uint64_t kTrialsOfAHang = 6;
/// Shrinking leaves this share of the depth of a miss, relative to its size.
constexpr double kDepthKept = 0.5;

/// How deep patches pass through each other in the failure that a case shows, as a share of their
/// largest coordinate; 0 where that is not measured.
double relative_depth(const Failure& failure, const Case& value, Asker& asker) {
  double size = 0;
  for (const MovingPatch<double>& patch : value.query.patches) {
    for (const Vec3<double>& p : patch.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  return size > 0 ? asker.depth(failure.who, checked_or_unknown(value)) / size : 0;
}

}  // namespace

Minimised shrink(const Case& found, const Failure& failure, Asker& asker, MinimiseOptions options) {
  if (failure.cause == "hang") options.max_trials = std::min(options.max_trials, kTrialsOfAHang);
  Case start = found;
  start.asked = asked_with(asker.search());
  start.expect.clear();
  // A deep one stays deep, so that what is left is no matter of rounding.
  const bool has_depth = is_false_negative(failure.outcome);
  const double least = has_depth ? kDepthKept * relative_depth(failure, start, asker) : 0;
  const bool is_admitted = options.admits(start);
  Minimised minimised = minimise(
      start, failure.outcome,
      [&](const Case& simpler) {
        return (!is_admitted || options.admits(simpler)) &&
               asker.failure(failure.who, simpler) == failure &&
               (least == 0 || relative_depth(failure, simpler, asker) >= least);
      },
      options);
  minimised.value.origin.name.clear();
  minimised.value.expect[failure.who] = {failure.outcome, failure.cause};
  return minimised;
}

}  // namespace ccdfuzz
