#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "io/child.hpp"
#include "io/descriptor.hpp"
#include "properties/shrink.hpp"

namespace ccdfuzz {

/// The results of one property on inputs.
struct CheckTally {
  std::uint64_t checked = 0, discarded = 0, failed = 0;
  std::uint64_t first_failure = 0;  ///< index of the input
  std::string text;                 ///< what the first failure says
  std::string error;                ///< the same: what running it ended in; mostly none
  bool is_cut_short = false;        ///< by an interruption or a hang
  double seconds = 0;

  bool all_discarded() const { return checked > 0 && discarded == checked; }
  /// Adds the tally of the inputs that come next.
  void add(const CheckTally& next);

  static void fields(auto& archive, auto& tally) {
    archive("checked", tally.checked);
    archive("discarded", tally.discarded);
    archive("failed", tally.failed);
    archive("first_failure", tally.first_failure);
    archive("text", tally.text);
  }
};

/// Runs properties in `ccdfuzz serve --claims`, a child that starts with the first input. Its crash
/// or hang ends it in place of this process, and the next input starts another.
class ServedClaims {
 public:
  /// interrupted: true ends what has taken long by then. starts_plugins: for claims about methods
  /// that are plug-ins. Its memory is not limited then, but theirs is. Errors: throws InputError's
  /// text where the program is not there, and std::system_error where the system refuses a file.
  explicit ServedClaims(const std::atomic<bool>* interrupted = nullptr,
                        bool starts_plugins = false);

  /// What ends the child is an error, with what is known of it as the text.
  InputRun on(const Property& property, const ChoiceNumbers& numbers);

  /// The draw of an index, as `ccdfuzz check` numbers them.
  InputRun on_draw(const Property& property, std::uint64_t seed, std::uint64_t index);
  /// `count` draws from the index on. Where one of them crashes, they are asked one by one, each
  /// that does as a failure; after one that hangs, no more.
  CheckTally on_draws(const Property& property, std::uint64_t seed, std::uint64_t first,
                      std::uint64_t count);

  /// The simplest input that fails as this one does: shrunk_counterexample. A hang comes back as it
  /// is, since each try would cost all its time. None if its choices do not show it. Then it does
  /// not fail each time, or it hangs on draws that are refused or too many for a command.
  /// found: what on_draw() gave, and fails; or what on() gave, and is no hang.
  std::optional<Counterexample> least(const Property& property, const InputRun& found,
                                      const ShrinkLimits& limits);

 private:
  InputRun ask(const Property& property, const char* of, const ChoiceNumbers& numbers);

  Descriptor made_;  ///< the choices that the child made, which outlive its crash: a file in memory
  Child child_;
};

/// The child's answer to a line.
std::string served_check(const std::vector<Property>& claims, const std::string& question);

}  // namespace ccdfuzz
