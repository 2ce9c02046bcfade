#include "eval/tally.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/verify.hpp"

namespace ccdfuzz {

void Tally::add(const Answer& answer, Outcome outcome, std::optional<bool> collides) {
  ++by_outcome[static_cast<size_t>(outcome)];
  if (outcome == Outcome::kNotAsked) return;
  ++n;
  if (collides) ++(*collides ? positives : negatives);
  pops += answer.pops;
  seconds += answer.seconds;
}

void Tally::merge(const Tally& other) {
  n += other.n;
  positives += other.positives;
  negatives += other.negatives;
  for (size_t i = 0; i < by_outcome.size(); ++i) by_outcome[i] += other.by_outcome[i];
  pops += other.pops;
  seconds += other.seconds;
}

double Samples::quantile(double q) const {
  CCDFUZZ_VERIFY(0 < q && q <= 1);
  if (all_.empty()) return 0;
  std::vector<double> sorted = all_;
  const auto n = static_cast<double>(sorted.size());
  const auto rank = static_cast<size_t>(std::clamp(std::ceil(q * n), 1.0, n)) - 1;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank),
                   sorted.end());
  return sorted[rank];
}

double Samples::mean() const {
  if (all_.empty()) return 0;
  return std::accumulate(all_.begin(), all_.end(), 0.0) / static_cast<double>(all_.size());
}

}  // namespace ccdfuzz
