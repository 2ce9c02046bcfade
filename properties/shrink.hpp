#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "generators/draw/shrink_choices.hpp"
#include "properties/property.hpp"

namespace ccdfuzz {

/// A failing input and its shrunk form.
struct Counterexample {
  ChoiceNumbers numbers;
  Check check;                ///< what it shows
  std::uint64_t tries = 0;    ///< runs of the property on simpler inputs
  bool is_cut_short = false;  ///< is_over said so: there may be simpler ones
};

/// When no more simpler inputs are tried. (The input itself, and what comes out, are run besides.)
struct ShrinkLimits {
  static constexpr std::uint64_t kTries = 4000;
  std::uint64_t tries = kTries;        ///< runs at most
  std::function<bool()> is_over = {};  ///< asked before each of them; empty: never over
};

/// The result of a property on an input, or the error by which the run ended.
struct InputRun {
  Check check;
  std::string error;      ///< its name ("crash SIGSEGV"), and check fails; empty: it ended
  ChoiceNumbers numbers;  ///< what it drew, until the error if there was one

  bool fails() const { return check.status == Check::Status::kFails; }
  /// In the same way.
  bool fails_as(const InputRun& other) const { return fails() && error == other.error; }
};

/// A way to run a property on choices.
using InputRunner = std::function<InputRun(const ChoiceNumbers&)>;

/// Shrinks a sequence of choices on which the property failed; the result fails in the same way,
/// which may be with another text. None if it does not fail each time that it is run on the same
/// choices.
std::optional<Counterexample> shrunk_counterexample(const InputRunner& runner,
                                                    const ChoiceNumbers& numbers,
                                                    const ShrinkLimits& limits);

}  // namespace ccdfuzz
