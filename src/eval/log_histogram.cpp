#include "eval/log_histogram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/double_parts.hpp"
#include "base/verify.hpp"

namespace ccdfuzz {

void LogHistogram::add(double sample) {
  ++count_;
  if (!is_finite(sample) || compare(sample, 0) <= 0) return;
  sum_ += sample;
  least_ = bins_.empty() ? sample : std::min(least_, sample);
  largest_ = std::max(largest_, sample);
  ++bins_[static_cast<int>(std::floor(std::log2(sample) * kBinsPerOctave))];
}

void LogHistogram::merge(const LogHistogram& other) {
  count_ += other.count_;
  sum_ += other.sum_;
  if (other.bins_.empty()) return;
  least_ = bins_.empty() ? other.least_ : std::min(least_, other.least_);
  largest_ = std::max(largest_, other.largest_);
  for (const auto& [bin, count] : other.bins_) bins_[bin] += count;
}

double LogHistogram::quantile(double q) const {
  CCDFUZZ_VERIFY(0 < q && q <= 1);
  std::uint64_t positive = 0;
  for (const auto& [bin, count] : bins_) positive += count;
  const double rank = std::max(std::ceil(q * static_cast<double>(count_)), 1.0);
  double seen = static_cast<double>(count_ - positive);
  if (count_ == 0 || rank <= seen) return 0;
  for (const auto& [bin, count] : bins_) {
    seen += static_cast<double>(count);
    if (seen < rank) continue;
    // More digits than the bin has would differ from one mathematical library to another.
    const std::string middle = fmt::format("{:.4g}", std::exp2((bin + 0.5) / kBinsPerOctave));
    return std::clamp(std::strtod(middle.c_str(), nullptr), least_, largest_);
  }
  return largest_;
}

}  // namespace ccdfuzz
