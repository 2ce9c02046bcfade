#pragma once

#include <optional>
#include <string>

#include "hunt/shared_choices.hpp"
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

  /// The simplest input that fails as this one does: shrunk_counterexample. A hang comes back as it
  /// is, since each try would cost its whole time; of draws, if it hangs on what they were, too.
  /// None if it does not fail each time. found: what on(input) gave, and fails.
  std::optional<Counterexample> least(const ClaimInput& input, const InputRun& found,
                                      const ShrinkLimits& limits);

 private:
  enum class Of : std::uint8_t { kNumbers, kBytes, kDraws };
  static std::string run_packed(const Property& property, SharedChoices& made,
                                const std::string& question);
  InputRun ask(Of of, const ChoiceNumbers& numbers);

  SharedChoices made_;
  ProcessApart apart_;
};

}  // namespace ccdfuzz
