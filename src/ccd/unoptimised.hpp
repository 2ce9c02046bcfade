#pragma once

#include <optional>
#include <span>

#include "ccd/search.hpp"
#include "ccd/tdibm.hpp"

namespace ccdfuzz {

/// A straightforward transcription of the paper. Each pair makes its sub-patches and axes anew.
/// Each axis and direction projects, sorts and builds its envelopes for itself. Reference for tests
/// and benchmarks: its answers are those of TdibmInclusion, bit for bit.
template <class Policy>
class UnoptimisedInclusion {
 public:
  explicit UnoptimisedInclusion(Policy policy, const Reading& reading = Policy::kReading)
      : policy_(policy), reading_(reading) {}

  void begin(const Query& query);
  void prepare(int side, std::span<const Cell> parts);
  std::optional<Window> test(int part_a, int part_b, const Window& window);

 private:
  Policy policy_;
  Reading reading_;
  const Query* query_ = nullptr;
  std::array<LargestComponents, 2> extents_;
  std::array<std::array<Cell, 4>, 2> cells_;
};

/// `tdibm@unoptimised` and so on.
template <class Policy>
using UnoptimisedTdibm = Search<UnoptimisedInclusion<Policy>>;

}  // namespace ccdfuzz
