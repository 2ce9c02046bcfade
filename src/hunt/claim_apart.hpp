#pragma once

#include <optional>
#include <span>
#include <string>

#include "method/process_apart.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// Runs a property in a copy of this process (ProcessApart), which its crash or hang ends in place
/// of this one.
class ClaimApart {
 public:
  ClaimApart(const Property& property, const ApartLimits& limits);

  /// What ends the copy is an error, with what is known of it as the text.
  InputRun on_bytes(std::span<const std::uint8_t> bytes);
  InputRun on_numbers(const ChoiceNumbers& numbers);

  /// The simplest input that fails as this one does: shrunk_counterexample. Of an error the bytes
  /// are made simpler in place of the numbers, which nobody knows; of a hang nothing, since each
  /// try would cost its whole time. found: what on_bytes(bytes) gave, and fails.
  std::optional<Counterexample> least(std::span<const std::uint8_t> bytes, const InputRun& found,
                                      const ShrinkLimits& limits);

 private:
  InputRun ask(const std::string& question);

  ProcessApart apart_;
};

}  // namespace ccdfuzz
