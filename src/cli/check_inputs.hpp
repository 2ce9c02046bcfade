#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "cli/terminal.hpp"
#include "hunt/served_claim.hpp"

namespace ccdfuzz {

/// Which inputs of a property to check: first, first + 1, … of the seed.
struct CheckedInputs {
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  std::uint64_t count = 1000;
  /// Instead of count: for so long, and until one input was not discarded or 1000 were.
  std::optional<double> seconds;
  int threads = 1;
};

/// As many children as are at work at once, for one property after another.
class ClaimChildren {
 public:
  /// stop: what has taken long by then is ended.
  explicit ClaimChildren(const std::atomic<bool>& stop) : stop_(stop) {}

  std::unique_ptr<ServedClaim> take(const Property& property);
  void give_back(std::unique_ptr<ServedClaim> claim);

 private:
  const std::atomic<bool>& stop_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<ServedClaim>> idle_;
};

/// In children, one for each thread. Depends on the inputs alone, except for the time that it took.
/// stop: no further inputs. on_failure is called once, as soon as the first failure is known, from
/// any thread.
CheckTally check_inputs(const Property& property, const CheckedInputs& inputs,
                        ClaimChildren& children, const std::atomic<bool>& stop, Progress& progress,
                        const std::function<void(const CheckTally&)>& on_failure);

}  // namespace ccdfuzz
