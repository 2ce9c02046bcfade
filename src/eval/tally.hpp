#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "case/answer.hpp"
#include "case/outcome.hpp"
#include "eval/log_histogram.hpp"

namespace ccdfuzz {

/// The results of one method on one group of queries. Merging and adding commute, so that nothing
/// depends on the order of the answers but the last bits of sums of times. What the method refused
/// is in by_outcome[kNotAsked] and in nothing else.
struct Tally {
  std::uint64_t n = 0;          ///< queries answered, none refused
  std::uint64_t positives = 0;  ///< those of them whose truth is a contact
  std::uint64_t negatives = 0;  ///< those of them whose truth is absence
  /// Those of positives and negatives whose answer is judged: rates are of these.
  std::uint64_t judged_positives = 0, judged_negatives = 0;
  std::array<std::uint64_t, kAllOutcomes.size()> by_outcome{};
  /// The most by which a hit is late; infinity where that of one is not known.
  double late_by = 0;
  std::uint64_t pops = 0;
  LogHistogram seconds, bytes;  ///< of each answer that is no error

  /// The counts.
  static void fields(auto& archive, auto& tally) {
    archive("n", tally.n);
    archive("positives", tally.positives);
    archive("negatives", tally.negatives);
    for (const Outcome o : kAllOutcomes) {
      archive(name_of(o), tally.by_outcome[static_cast<size_t>(o)]);
    }
    archive.optional("late_by", tally.late_by);
  }

  /// What the answers cost, and how many rates are of. It can be written, not read.
  static void measures(auto& archive, const Tally& tally) {
    const std::uint64_t n = tally.seconds.count();
    const double pops = static_cast<double>(tally.pops);
    archive("mean_pops", n == 0 ? 0.0 : pops / static_cast<double>(n));
    archive("mean_bytes", tally.bytes.mean());
    archive("median_bytes", tally.bytes.median());
    archive("p99_bytes", tally.bytes.p99());
    archive("max_bytes", tally.bytes.largest());
    archive("mean_seconds", tally.seconds.mean());
    archive("median_seconds", tally.seconds.median());
    archive("p99_seconds", tally.seconds.p99());
    archive("judged_positives", tally.judged_positives);
    archive("judged_negatives", tally.judged_negatives);
  }

  /// The last is as of Judged.
  void add(const Cost& cost, Outcome outcome, std::optional<bool> collides, double late = 0) {
    ++by_outcome[static_cast<size_t>(outcome)];
    if (outcome == Outcome::kNotAsked) return;
    ++n;
    if (collides) ++(*collides ? positives : negatives);
    if (collides && is_judged(outcome)) ++(*collides ? judged_positives : judged_negatives);
    if (outcome == Outcome::kLate) {
      late_by = std::max(late_by, late > 0 ? late : std::numeric_limits<double>::infinity());
    }
    if (outcome == Outcome::kError) return;
    pops += cost.pops;
    seconds.add(cost.seconds);
    bytes.add(static_cast<double>(cost.bytes));
  }
  void merge(const Tally& other) {
    n += other.n;
    positives += other.positives;
    negatives += other.negatives;
    judged_positives += other.judged_positives;
    judged_negatives += other.judged_negatives;
    for (size_t i = 0; i < by_outcome.size(); ++i) by_outcome[i] += other.by_outcome[i];
    late_by = std::max(late_by, other.late_by);
    pops += other.pops;
    seconds.merge(other.seconds);
    bytes.merge(other.bytes);
  }

  std::uint64_t count(Outcome outcome) const { return by_outcome[static_cast<size_t>(outcome)]; }
  /// The number of answers that the outcome's rate is a share of.
  std::uint64_t of_which(Outcome outcome) const {
    if (is_false_negative(outcome)) return judged_positives;
    return outcome == Outcome::kFalsePositive ? judged_negatives : n;
  }
  std::uint64_t not_asked() const { return count(Outcome::kNotAsked); }
};

}  // namespace ccdfuzz
