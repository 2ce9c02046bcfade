#pragma once

#include <cstdint>
#include <optional>

#include "case/case.hpp"
#include "ccd/witness_trace/trace.hpp"

namespace ccdfuzz {

/// A loss of the witness, measured in exact arithmetic at the time t* of the contact. It is of the
/// pair of parts that the method separated, and along the axis by which it did.
struct LossFacts {
  struct Overlap {
    /// By how much the parts overlap along the unit axis, ≥ 0 since they touch; rounded.
    double length = 0;
    /// An ulp of the largest height |axis·control point| at t*, of the same unit.
    double height_ulp = 0;
  };
  /// None if the axis is no direction: zero, or past the range of doubles.
  std::optional<Overlap> overlap;
  /// How many doubles the end of the excluded times is past t*, though it should be before it; of
  /// two ends the nearer one. None if the window cuts off both ends: the axis claims all that is
  /// left of the time.
  std::optional<std::uint64_t> ulps_past;
};

/// Requires a loss by an axis (loss.by.axis ≥ 0) of a valid query's witness.
LossFacts facts_of(const Query& query, const Witness& witness, const Trace::Loss& loss);

}  // namespace ccdfuzz
