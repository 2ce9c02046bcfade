#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>

#include "cli/output.hpp"
#include "hunt/served_claim.hpp"

namespace ccdfuzz {

/// Which inputs of a property to check: first, first + 1, … of the seed.
struct CheckedInputs {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t count = 1000;
  /// Instead of count: for so long. Then, and about a method, until one input was not discarded, or
  /// 1000 were.
  std::optional<double> seconds;
  int threads = 1;
};

/// A child for each thread.
using ClaimChildren = tbb::enumerable_thread_specific<ServedClaims>;

/// Depends on the inputs alone, except for the time that it took.
/// stop: no further inputs. on_failure is called once, as soon as the first failure is known, from
/// any thread.
CheckTally check_inputs(const Property& property, const CheckedInputs& inputs,
                        ClaimChildren& children, const std::atomic<bool>& stop, Progress& progress,
                        const std::function<void(const CheckTally&)>& on_failure);

}  // namespace ccdfuzz
