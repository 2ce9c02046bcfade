#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "case/answer.hpp"
#include "case/outcome.hpp"

namespace ccdfuzz {

/// What one method did on one group of queries, in counts. Merging and adding commute, so the
/// counts do not depend on the order of the answers; only `seconds` may, in its last bits. What the
/// method refused is in by_outcome[kNotAsked] and in nothing else.
struct Tally {
  std::uint64_t n = 0;          ///< queries answered, none refused
  std::uint64_t positives = 0;  ///< of them, those whose truth is a contact
  std::uint64_t negatives = 0;  ///< of them, those whose truth is absence
  std::array<std::uint64_t, kAllOutcomes.size()> by_outcome{};
  std::uint64_t pops = 0;
  double seconds = 0;

  /// The counts; neither pops nor seconds.
  static void fields(auto& archive, auto& tally) {
    archive("n", tally.n);
    archive("positives", tally.positives);
    archive("negatives", tally.negatives);
    for (const Outcome o : kAllOutcomes) {
      archive(name_of(o), tally.by_outcome[static_cast<size_t>(o)]);
    }
  }

  void add(const Answer& answer, Outcome outcome, std::optional<bool> collides);
  void merge(const Tally& other);

  std::uint64_t count(Outcome outcome) const { return by_outcome[static_cast<size_t>(outcome)]; }
  std::uint64_t not_asked() const { return count(Outcome::kNotAsked); }
  std::uint64_t false_negatives() const { return count(Outcome::kMissed) + count(Outcome::kLate); }
  /// 0 if there was no query.
  double mean_seconds() const { return n == 0 ? 0 : seconds / static_cast<double>(n); }
};

/// Measurements of a group, kept one by one for their quantiles.
class Samples {
 public:
  void add(double x) { all_.push_back(x); }
  void append(const Samples& o) { all_.insert(all_.end(), o.all_.begin(), o.all_.end()); }

  /// Nearest rank: the least sample that at least ⌈q·n⌉ of the n samples do not exceed.
  /// 0 < q ≤ 1; 0 if there is no sample.
  double quantile(double q) const;
  double median() const { return quantile(0.5); }
  double p99() const { return quantile(0.99); }
  double largest() const { return quantile(1); }
  /// 0 if there is no sample.
  double mean() const;

  const std::vector<double>& all() const { return all_; }

 private:
  std::vector<double> all_;
};

/// Running times, in seconds.
using Timings = Samples;

}  // namespace ccdfuzz
