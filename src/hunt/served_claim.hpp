#pragma once

#include <optional>
#include <string>

#include "base/child.hpp"
#include "properties/fuzz_targets.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// The choices that a child made, which outlive its crash: in a file in memory that both have.
class MadeChoices {
 public:
  /// Errors: throws std::system_error where the system refuses a file.
  MadeChoices();
  ~MadeChoices();
  MadeChoices(const MadeChoices&) = delete;
  MadeChoices& operator=(const MadeChoices&) = delete;

  int descriptor() const { return file_; }
  void clear();
  /// Sets run.numbers and run.bytes.
  void read_into(InputRun& run) const;

 private:
  int file_;
};

/// Runs a property in `ccdfuzz serve --claim NAME`, which its crash or hang ends in place of this
/// process.
class ServedClaim {
 public:
  /// Errors: throws InputError's text where the program is not there.
  explicit ServedClaim(const Property& property);

  /// What ends the child is an error, with what is known of it as the text.
  InputRun on(const ClaimInput& input);

  /// The simplest input that fails as this one does: shrunk_counterexample. A hang comes back as it
  /// is, since each try would cost its whole time; of draws, if it hangs on what they were, too.
  /// None if it does not fail each time. found: what on(input) gave, and fails.
  std::optional<Counterexample> least(const ClaimInput& input, const InputRun& found,
                                      const ShrinkLimits& limits);

 private:
  InputRun ask(const char* of, const ChoiceNumbers& numbers);

  MadeChoices made_;
  Child child_;
};

/// What the child answers to a line.
std::string served_check(const Property& property, const std::string& question);

}  // namespace ccdfuzz
