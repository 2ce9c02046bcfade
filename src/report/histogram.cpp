#include "report/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

namespace {

constexpr int kFineInCoarse = 8;
constexpr int kCoarsePerOctave = LogHistogram::kBinsPerOctave / kFineInCoarse;
constexpr size_t kLinearBins = 200;

int coarse_bin(int fine) {
  return static_cast<int>(std::floor(static_cast<double>(fine) / kFineInCoarse));
}

}  // namespace

Histogram log_bins(const LogHistogram& samples) {
  const auto& bins = samples.bins();
  if (bins.empty()) return {};
  const int first = coarse_bin(bins.begin()->first), last = coarse_bin(bins.rbegin()->first);
  const double width = std::log10(2) / kCoarsePerOctave;
  Histogram histogram{first * width, width, {}};
  histogram.counts.resize(static_cast<size_t>(last - first) + 1);
  for (const auto& [bin, count] : bins) {
    histogram.counts[static_cast<size_t>(coarse_bin(bin) - first)] += count;
  }
  return histogram;
}

Histogram linear_bins(const LogHistogram& samples, double share) {
  const double most = samples.quantile(share);
  if (!(most > 0)) return {};
  Histogram histogram{0, most / static_cast<double>(kLinearBins), {}};
  histogram.counts.resize(kLinearBins);
  std::uint64_t zeros = samples.count();
  for (const auto& [bin, count] : samples.bins()) {
    const double at = std::exp2((bin + 0.5) / LogHistogram::kBinsPerOctave) / histogram.width;
    const auto place = static_cast<size_t>(std::min(at, static_cast<double>(kLinearBins - 1)));
    histogram.counts[place] += count;
    zeros -= count;
  }
  histogram.counts[0] += zeros;
  return histogram;
}

}  // namespace ccdfuzz
