#include "report/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace ccdfuzz {

namespace {

constexpr double kPerDecade = 10;
constexpr size_t kLinearBins = 200;

}  // namespace

Histogram log_histogram(const std::vector<double>& samples) {
  const auto bin_of = [](double x) {
    return static_cast<long>(std::floor(std::log10(x) * kPerDecade));
  };
  std::vector<long> bins;
  bins.reserve(samples.size());
  for (const double x : samples) {
    if (x > 0 && std::isfinite(x)) bins.push_back(bin_of(x));
  }
  if (bins.empty()) return {};
  const auto [least, greatest] = std::ranges::minmax_element(bins);
  Histogram histogram{true, static_cast<double>(*least) / kPerDecade, 1 / kPerDecade, {}};
  histogram.counts.resize(static_cast<size_t>(*greatest - *least) + 1);
  for (const long bin : bins) ++histogram.counts[static_cast<size_t>(bin - *least)];
  return histogram;
}

Histogram linear_histogram(const std::vector<double>& samples, double share) {
  if (samples.empty()) return {};
  std::vector<double> sorted = samples;
  std::ranges::sort(sorted);
  const auto rank = static_cast<size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  const double most = sorted[std::clamp<size_t>(rank, 1, sorted.size()) - 1];
  if (!(most > 0) || !std::isfinite(most)) return {};
  Histogram histogram{false, 0, most / static_cast<double>(kLinearBins), {}};
  histogram.counts.resize(kLinearBins);
  for (const double x : sorted) {
    const double bin = std::clamp(x / histogram.width, 0.0, static_cast<double>(kLinearBins - 1));
    ++histogram.counts[static_cast<size_t>(bin)];
  }
  return histogram;
}

}  // namespace ccdfuzz
