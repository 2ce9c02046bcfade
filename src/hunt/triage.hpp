#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "finds/intake.hpp"
#include "io/child.hpp"
#include "method/served_method.hpp"

namespace ccdfuzz {

struct TriageOptions {
  std::vector<std::string> methods;  ///< specs that parse_method accepted
  SearchOptions search;
  std::uint64_t shrink_trials = 1000;  ///< for one find
  /// True ends shrinking, and asking before the next method.
  std::function<bool()> stop = [] { return false; };
  MethodSet::Make make = make_served_method;
  /// Arguments of serve, of a child that answers as served_errand.
  std::vector<std::string> errands = {"--triage"};
  /// Called for an input on which the oracle fails, but not as a method; and for a refutation.
  std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// The counts of the inputs.
struct TriageTally {
  std::uint64_t inputs = 0;
  std::uint64_t failures = 0;  ///< full runs that fail, of all inputs and methods
  std::uint64_t known = 0;     ///< how many of those are like one that was known
  std::uint64_t harmless = 0;  ///< inputs that no method fails on, in a full run
  std::uint64_t refuting = 0;  ///< inputs that refute a claim, but by no full run of a sound method

  static void fields(auto& archive, auto& tally) {
    archive("inputs", tally.inputs);
    archive("failures", tally.failures);
    archive("known", tally.known);
    archive("harmless", tally.harmless);
    archive("refuting", tally.refuting);
  }
};

/// Takes what fuzzers found into a store. It is confirmed by full runs up to the contact and past
/// it, shrunk exactly, and kept if its failure was not known. Methods and oracle work in children,
/// so that this process survives whatever they do.
class Triage {
 public:
  Triage(Store& store, TriageOptions options);

  /// A case with its truth, or without: then the oracle decides it, whose crash or hang is a find
  /// of the method "oracle". Calls found for each new failure, with the find as it was stored. What
  /// refutes a claim of sound methods, but by none of their full runs, is passed to options.warn.
  /// Errors: of the store.
  using Found = std::function<void(const Failure& failure, const Case& find)>;
  Result<void> add(const Case& candidate, const Found& found);

  const TriageTally& tally() const { return tally_; }

 private:
  Asker make_asker();
  /// What a child says of a case, or what it did instead. method: of a loss.
  struct Told;
  friend std::string served_errand(const std::string& question);
  tl::expected<Told, Fault> told(const char* errand, const Case& value,
                                 const std::string& method = "");
  /// A case without truth as the oracle decides it, or what it did instead.
  tl::expected<Case, Fault> with_truth(const Case& candidate);
  /// The failure in the form whose setting convinces most; nothing if it fails in none.
  std::optional<Find> confirm(const std::string& method, const Case& known);
  /// Shrinks and stores what shows a new failure. Nothing if there was no time for that.
  Result<std::optional<Case>> take_in(const Find& confirmed);

  TriageOptions options_;
  TriageTally tally_;
  Asker asker_;
  Intake intake_;
  std::optional<Child> errands_;
};

/// The answer of a child to a line of Triage, about a step that may crash or hang. To "decide": the
/// truth of a case, as far as little effort gives one. To "loss": the cause that lost its contact.
/// To "refute": how a case refutes the methods that miss nothing, or the oracle, where a full run
/// of theirs does not. The witness trace of one loses the contact, which another box may save; a
/// coarse search misses it; or the checker refuses the oracle's certificate. Empty: it does not.
std::string served_errand(const std::string& question);

}  // namespace ccdfuzz
