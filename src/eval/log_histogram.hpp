#pragma once

#include <cstdint>
#include <map>

namespace ccdfuzz {

/// Counts of samples in bins of a 32nd of an octave. Quantiles are those of the samples to 1.2 %,
/// merging two is exact, and the memory does not grow with the number of samples.
class LogHistogram {
 public:
  static constexpr int kBinsPerOctave = 32;

  /// Samples that are not > 0 and finite count as 0.
  void add(double sample);
  void merge(const LogHistogram& other);

  std::uint64_t count() const { return count_; }
  double sum() const { return sum_; }
  /// 0 if there is no sample.
  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }
  /// Exact; 0 if there is no sample.
  double largest() const { return largest_; }
  /// Nearest rank: the middle, to four digits, of the bin of the least sample that at least ⌈q·n⌉
  /// of the n samples do not exceed. 0 < q ≤ 1; 0 if there is no sample.
  double quantile(double q) const;
  double median() const { return quantile(0.5); }
  double p99() const { return quantile(0.99); }

  /// Counts of the samples > 0 by bin: of those from 2^(bin/32) to below 2^((bin + 1)/32).
  const std::map<int, std::uint64_t>& bins() const { return bins_; }

  friend bool operator==(const LogHistogram&, const LogHistogram&) = default;

 private:
  std::map<int, std::uint64_t> bins_;
  std::uint64_t count_ = 0;
  double sum_ = 0;
  double least_ = 0, largest_ = 0;  ///< among the samples > 0
};

}  // namespace ccdfuzz
