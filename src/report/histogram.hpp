#pragma once

#include <cstdint>
#include <vector>

#include "eval/log_histogram.hpp"

namespace ccdfuzz {

/// Counts in bins of equal width from `lo` on, as a page draws them.
struct Histogram {
  double lo = 0;
  double width = 0;
  std::vector<std::uint64_t> counts;
};

/// The histogram of the decimal logarithms of the samples > 0, in bins of a quarter of an octave.
/// Empty if there is none.
Histogram log_bins(const LogHistogram& samples);

/// 200 bins from 0 to the sample that `share` of them do not exceed; the last bin holds those past
/// it, too. Each sample counts as the middle of its bin of LogHistogram. Empty if there is none
/// above 0. Requires 0 < share ≤ 1.
Histogram linear_bins(const LogHistogram& samples, double share);

}  // namespace ccdfuzz
