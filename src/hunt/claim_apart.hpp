#pragma once

#include <optional>
#include <string>

#include "method/process_apart.hpp"
#include "properties/fuzz_targets.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// Runs a property in a copy of this process (ProcessApart), which its crash or hang ends in place
/// of this one.
class ClaimApart {
 public:
  ClaimApart(const Property& property, const ApartLimits& limits);

  /// What ends the copy is an error, with what is known of it as the text.
  InputRun on(const ClaimInput& input);

  /// The simplest input that fails as this one does: shrunk_counterexample. Of an error the bytes
  /// are made simpler in place of the numbers, which nobody knows; of a hang nothing, since each
  /// try would cost its whole time. None if it does not fail each time; nor of an error on draws.
  /// found: what on(input) gave, and fails.
  std::optional<Counterexample> least(const ClaimInput& input, const InputRun& found,
                                      const ShrinkLimits& limits);

 private:
  enum class Of : std::uint8_t { kNumbers, kBytes, kDraws };
  static std::string run_packed(const Property& property, const std::string& question);
  InputRun ask(Of of, const ChoiceNumbers& numbers);

  ProcessApart apart_;
};

}  // namespace ccdfuzz
