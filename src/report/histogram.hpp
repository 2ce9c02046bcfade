#pragma once

#include <cstdint>
#include <vector>

namespace ccdfuzz {

/// Counts of samples in bins of equal width from `lo` on; of their decimal logarithms if `log`.
struct Histogram {
  bool log = false;
  double lo = 0;
  double width = 0;
  std::vector<std::uint64_t> counts;
};

/// Bins of a tenth of a decade, from the least to the greatest of the samples, which are > 0;
/// others are left out. Empty if none is.
Histogram log_histogram(const std::vector<double>& samples);

/// 200 bins from 0 to the sample that `share` of them do not exceed (nearest rank); the last bin
/// holds those past it, too. Empty if there is none above 0. Requires 0 < share ≤ 1.
Histogram linear_histogram(const std::vector<double>& samples, double share);

}  // namespace ccdfuzz
