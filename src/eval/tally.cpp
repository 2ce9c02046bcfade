#include "eval/tally.hpp"

namespace ccdfuzz {

void Tally::add(const Answer& answer, Outcome outcome, std::optional<bool> collides) {
  ++by_outcome[static_cast<size_t>(outcome)];
  if (outcome == Outcome::kNotAsked) return;
  ++n;
  if (collides) ++(*collides ? positives : negatives);
  pops += answer.pops;
  seconds.add(answer.seconds);
  bytes.add(static_cast<double>(answer.bytes));
}

void Tally::merge(const Tally& other) {
  n += other.n;
  positives += other.positives;
  negatives += other.negatives;
  for (size_t i = 0; i < by_outcome.size(); ++i) by_outcome[i] += other.by_outcome[i];
  pops += other.pops;
  seconds.merge(other.seconds);
  bytes.merge(other.bytes);
}

}  // namespace ccdfuzz
